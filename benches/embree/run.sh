#!/bin/sh
# The same triangles and rays through Embree 3 (apt-get install libembree-dev) and durer, one thread each.
set -e
cd "$(dirname "$0")"
data=${TMPDIR:-/tmp}/durer_mesh.bin
cargo bench -p durer-benches --bench mesh -- write "$data"
g++ -O2 -o "${TMPDIR:-/tmp}/durer_embree" embree.cpp -lembree3
echo "Embree 3, robust"
"${TMPDIR:-/tmp}/durer_embree" "$data" robust
echo "durer"
cargo bench -p durer-benches --bench mesh -- run
