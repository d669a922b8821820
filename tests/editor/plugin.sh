#!/usr/bin/env bash
# editors/neovim in Neovim (0.7 and later): colours, kinds of files, the language server, what code lenses ask for. plugin.sh [DURER]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
durer=$(realpath "${1:-$(command -v durer)}")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp "$here"/sample.pov "$here"/sample.ini "$place"
printf '[section]\nWidth=3\nheight=2\nname=x\n' > "$place/other.ini"
printf 'Width=3\nheight = 2\n' > "$place/size.ini"
cd "$place"
DURER=$durer XDG_CONFIG_HOME=$place XDG_DATA_HOME=$place XDG_STATE_HOME=$place timeout 60 nvim --headless -i NONE -n \
    --cmd "set runtimepath^=$here/../../editors/neovim" --cmd "let g:durer_path = '$durer'" --cmd 'syntax on' \
    -u /dev/null sample.pov -c "luafile $here/plugin.lua" -c "cquit 1"
