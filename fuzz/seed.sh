#!/usr/bin/env bash
# Fills the corpora of the fuzzers, fuzz/corpus/TARGET/, with small files of the repository.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

corpus=fuzz/corpus
mkdir -p $corpus
cp -r fuzz/seeds/. $corpus/

# Copies the small ones of the files whose names are read from the standard input, each under its whole path.
copy_to() {
    mkdir -p "$corpus/$1"
    while IFS= read -r file; do
        if [ "$(stat -c %s "$file")" -le "$2" ]; then
            cp "$file" "$corpus/$1/${file//\//_}"
        fi
    done
}

for target in parse format interpret render; do
    git ls-files 'scenes/**.scene' 'tests/**.scene' 'docs/**.scene' 'tests/**.inc' | copy_to $target 4000
done
# Texts in the table of hostile inputs are parts of Rust files, which are hostile inputs themselves.
git ls-files 'tests/cases/hostile/*.rs' | copy_to parse 20000
git ls-files 'tests/**.before' | copy_to format 4000
git ls-files '*.png' | copy_to picture_png 3000
git ls-files '*.ppm' | copy_to picture_netpbm 3000
git ls-files '*.df3' | copy_to density 3000
git ls-files '*.ply' | copy_to mesh_ply 3000
git ls-files '*.obj' | copy_to mesh_obj 3000
git ls-files '*.ini' | copy_to options 3000
git ls-files '*.ttf' | copy_to font 200000
