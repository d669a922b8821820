#!/usr/bin/env python3
"""Writes src/library/index.txt: which include file of POV-Ray declares which name. Names alone are kept, nothing of what they stand for.

    index.py [FOLDER]

It reads the include files of an installed POV-Ray, and takes what `#declare` and `#macro` name outside of macros' bodies.
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
OUT = HERE.parent.parent / "src" / "library" / "index.txt"
FOLDERS = ["/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include"]

# Where several files declare a name, the first of them is the one to include: these come last.
LAST = ["golds.inc", "glass_old.inc", "shapes_old.inc", "stoneold.inc", "stage1.inc", "stdcam.inc", "debug.inc"]
# Tables that others include, and what declares nothing for others.
LEFT_OUT = ["stdinc.inc"]

# Strings and comments first, so that nothing in them counts.
TOKEN = re.compile(
    r'"(?:[^"\\]|\\.)*"|//[^\n]*|/\*.*?\*/'
    r"|#\s*(?P<word>[a-z]+)(?:\s*(?:deprecated(?:\s+once)?\s*(?:\"[^\"]*\"\s*)?)?(?P<name>[A-Za-z_]\w*))?",
    re.DOTALL,
)
OPENS = {"if", "ifdef", "ifndef", "while", "for", "switch"}


def declared(text):
    """The names that a file declares for those who include it, in its order."""
    names, depths = {}, []
    for token in TOKEN.finditer(text):
        word, name = token["word"], token["name"]
        inside = "macro" in depths
        if word in ("declare", "macro") and name and not inside and not is_inner(name):
            names[name] = None
        if word in OPENS or word == "macro":
            depths.append(word)
        elif word == "end" and depths:
            depths.pop()
    return list(names)


def is_inner(name):
    """A guard or an auxiliary name of the file's own."""
    return len(name) == 1 or bool(re.search(r"^_|_inc(_temp)?$|_temp$|_inc_stack$", name, re.IGNORECASE))


def part_of(path, texts):
    """The file that is included in this one's place: `stones.inc` for `stones1.inc`, which it includes."""
    for name, text in texts.items():
        stem = name.removesuffix(".inc")
        if name != path.name and path.name.startswith(stem) and f'#include "{path.name}"' in text:
            return name
    return None


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else next(f for f in FOLDERS if pathlib.Path(f).is_dir()))
    files = sorted(folder.glob("*.inc"), key=lambda path: (path.name in LAST, path.name))
    lines = ["# Written by tests/library/index.py: the names that the standard include files declare, a file a line; `=` the file that includes it."]
    texts = {path.name: path.read_text(encoding="latin-1") for path in files}
    for path in files:
        names = [] if path.name in LEFT_OUT else declared(texts[path.name])
        whole = part_of(path, texts)
        lines.append(" ".join([f"{path.name}={whole}" if whole else path.name, *names]))
    OUT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"{OUT}: {sum(len(line.split()) - 1 for line in lines[1:])} names of {len(files)} files")


if __name__ == "__main__":
    main()
