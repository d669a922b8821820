#!/usr/bin/env bash
# Makes durer-VERSION.vsix in this folder, or in the one that is given, and lists what is in it. Needs npm and the network.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=$(cd "${1:-$here}" && pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp -r "$here"/{.vscodeignore,package.json,package-lock.json,*-configuration.json,options.json,extension.js,syntaxes,README.md} "$place"
cp "$here/../../LICENSE-MIT" "$place/LICENSE"
cd "$place"
npm ci --no-audit --no-fund
# One file instead of 200; whose work is in it is told beside it.
npx --yes esbuild@0.25 extension.js --bundle --platform=node --external:vscode --log-level=warning --outfile=bundle.js
mv bundle.js extension.js
for licence in node_modules/*/[Ll][Ii][Cc][Ee][Nn][CcSs][Ee]*; do
    printf '== %s\n\n%s\n\n' "$(basename "$(dirname "$licence")")" "$(cat "$licence")"
done > ThirdPartyNotices.txt
npx --yes @vscode/vsce@3 package --no-dependencies --allow-missing-repository --out "$out"
npx --yes @vscode/vsce@3 ls --no-dependencies
