#!/usr/bin/env bash
# editors/emacs in Emacs (27.1 and later): compiles without a warning, colours, indents our own scenes as they are, and
# speaks with the language server where there is eglot (part of Emacs 29, Debian's elpa-eglot). emacs.sh [DURER]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
durer=$(realpath "${1:-$(command -v durer)}")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp "$here"/../../editors/emacs/*.el "$here"/sample.* "$place"
cd "$place"
printf '[section]\nWidth=3\nheight=2\nname=x\n' > other.ini
printf 'Width=3\nheight = 2\n' > size.ini
emacs --batch -Q -L . --eval '(setq byte-compile-error-on-warn t)' -f batch-byte-compile povray-words.el povray-mode.el
# Debian's packages, which -Q leaves out.
packages=/usr/share/emacs/site-lisp/elpa
[ -d "$packages" ] && paths=$(printf -- '-L %s ' "$packages"/*/) || paths=
# shellcheck disable=SC2086
DURER=$durer SCENES=$here/../../scenes timeout 120 emacs --batch -Q $paths -L . -l "$here/emacs.el"
