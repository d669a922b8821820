#!/bin/sh
# The same triangles and rays through Embree 3 (apt-get install libembree-dev) and durer, one thread each, by turns: the best of all rounds.
# usage: run.sh [ROUNDS]. Embree asks for huge pages, durer does not: so it is measured with and without them.
set -e
cd "$(dirname "$0")"
rounds=${1:-5}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
data=$folder/data.bin
cargo bench -q -p durer-benches --bench mesh -- write "$data"
g++ -O2 -o "$folder/embree" embree.cpp -lembree3

measure() {
    name=$1
    shift
    "$@" | sed "s/^/$name | /"
}
for _ in $(seq "$rounds"); do
    measure "durer" cargo bench -q -p durer-benches --bench mesh -- run 2
    measure "Embree, robust" "$folder/embree" "$data" 2 robust
    measure "Embree, robust, small pages" "$folder/embree" "$data" 2 robust small
    measure "Embree" "$folder/embree" "$data" 2
done | awk -F ': ' '
    !($1 in best) { order[++count] = $1; best[$1] = $2; next }
    ($1 ~ /build$/) == ($2 + 0 < best[$1] + 0) { best[$1] = $2 }
    END { for (i = 1; i <= count; i++) print order[i] ": " best[order[i]] }'
