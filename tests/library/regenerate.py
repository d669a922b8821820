#!/usr/bin/env python3
"""Asks the real POV-Ray, with its own include files, for the values of tests/library/*.scene.

    regenerate.py [--write] [FILE.scene ...]

The same as tests/lang/regenerate.py, for the files of this folder.
"""

import importlib.util
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
spec = importlib.util.spec_from_file_location("regenerate", HERE.parent / "lang" / "regenerate.py")
lang = importlib.util.module_from_spec(spec)
spec.loader.exec_module(lang)
lang.FOLDER = HERE
ask = lang.ask


def without_text(text):
    """What POV-Ray prints, without the lines of its files that it quotes."""
    printed, fine, complaint = ask(text)
    return printed, fine, complaint[complaint.find(b"Parse Error") :]


lang.ask = without_text

if __name__ == "__main__":
    sys.exit(lang.main())
