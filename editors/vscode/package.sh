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
npx --yes @vscode/vsce@3 package --skip-license --allow-missing-repository --out "$out"
npx --yes @vscode/vsce@3 ls
