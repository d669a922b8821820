#!/usr/bin/env bash
# The TextMate grammars in what Visual Studio Code reads them with: over all our scenes, and scopes at some places. Needs npm.
# textmate.sh [FOLDER…]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
place=${TEXTMATE_PLACE:-/tmp/durer-textmate}
if ! [ -d "$place/node_modules/vscode-textmate" ]; then
    npm install --silent --no-audit --no-fund --prefix "$place" vscode-textmate@9 vscode-oniguruma@2
fi
NODE_PATH=$place/node_modules timeout 300 node "$here/textmate.js" "$@"
