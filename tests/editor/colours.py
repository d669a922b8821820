#!/usr/bin/env python3
"""The grammar for tree-sitter, compiled as editors compile it: all our scenes are whole, and words at some places have their colours.

    colours.py

Needs a C compiler and the package `tree-sitter` of PyPI.
"""

import ctypes
import pathlib
import subprocess
import sys
import tempfile
import warnings

from tree_sitter import Language, Parser, Query, QueryCursor

HERE = pathlib.Path(__file__).resolve().parent
GRAMMAR = HERE.parent.parent / "editors" / "tree-sitter-povray"
# Its brackets do not balance on purpose.
LOPSIDED = {"unbalanced.scene"}

# Of `sample.pov`: line, column (both from 0), what it is coloured as.
COLOURS = [
    (0, 3, "comment.line"),
    (1, 4, "comment.block"),
    (1, 45, "comment.block"),
    (2, 1, "keyword.directive"),
    (3, 10, "variable"),
    (3, 18, "constant.numeric"),
    (4, 8, "function.macro"),
    (4, 13, "variable.parameter"),
    (5, 3, "type"),
    (6, 5, "keyword"),
    (6, 14, "attribute"),
    (6, 22, "function.builtin"),
    (6, 30, "constant.builtin"),
    (10, 3, "function"),
    (11, 2, "keyword.directive"),
    (12, 10, "string"),
    (12, 18, "constant.character.escape"),
    (18, 3, "keyword.directive"),
    (19, 13, None),
    (22, 2, "keyword.directive"),
]


def language(folder):
    library = pathlib.Path(folder) / "povray.so"
    source = GRAMMAR / "src"
    subprocess.run(["cc", "-O1", "-fPIC", "-shared", f"-I{source}", source / "parser.c", "-o", library], check=True)
    make = ctypes.CDLL(str(library)).tree_sitter_povray
    make.restype = ctypes.c_void_p
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        return Language(make())


def coloured(povray, text):
    """Each place's scope."""
    query = Query(povray, (GRAMMAR / "queries" / "highlights.scm").read_text())
    found = {}
    for scope, nodes in QueryCursor(query).captures(Parser(povray).parse(text).root_node).items():
        for node in nodes:
            found.setdefault((node.start_byte, node.end_byte), set()).add(scope)
    return found


def main():
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        povray = language(folder)
    for name in ("indents", "textobjects"):
        Query(povray, (GRAMMAR / "queries" / f"{name}.scm").read_text())
    scenes = sorted((HERE.parent.parent / "scenes").rglob("*.scene"))
    for path in scenes:
        if Parser(povray).parse(path.read_bytes()).root_node.has_error != (path.name in LOPSIDED):
            faults.append(f"{path}: errors, or none where there should be some")
    text = (HERE / "sample.pov").read_bytes()
    found = coloured(povray, text)
    faults += [f"{place} has two colours: {scopes}" for place, scopes in found.items() if len(scopes) > 1]
    starts = [0, *(i + 1 for i, byte in enumerate(text) if byte == 10)]
    for line, column, scope in COLOURS:
        at = starts[line] + column
        around = [(end - start, scopes) for (start, end), scopes in found.items() if start <= at < end]
        seen = min(around, key=lambda one: one[0])[1] if around else {None}
        if seen != {scope}:
            faults.append(f"sample.pov:{line + 1}:{column + 1} is {seen}, not {scope}")
    print("\n".join(faults) if faults else f"ok: {len(scenes)} scenes, {len(COLOURS)} places")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
