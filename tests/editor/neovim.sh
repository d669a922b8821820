#!/usr/bin/env bash
# A real editor with `durer lsp` at its other end: messages, completion, hover, rename, layout. neovim.sh [DURER]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
durer=$(realpath "${1:-$(command -v durer)}")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
printf '#declare Ball = sphere { 0, 1 };\n' > "$place/parts.inc"
printf '#include "parts.inc"\ncamera { location -5 * z }\nobject   { Ball  pigmant { rgb 1 } }\n' > "$place/hall.pov"
cd "$place"
DURER=$durer timeout 60 nvim --headless -u NONE -i NONE -n hall.pov -c "luafile $here/neovim.lua" -c "cquit 1"
