#!/usr/bin/env bash
# editors/emacs in Emacs (27.1 and later): compiles without a warning, colours, indents our own scenes as they are. emacs.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp "$here"/../../editors/emacs/*.el "$here"/sample.* "$place"
cd "$place"
printf '[section]\nWidth=3\nname=x\n' > other.ini
emacs --batch -Q -L . --eval '(setq byte-compile-error-on-warn t)' -f batch-byte-compile povray-words.el povray-mode.el
SCENES=$here/../../scenes timeout 120 emacs --batch -Q -L . -l "$here/emacs.el"
