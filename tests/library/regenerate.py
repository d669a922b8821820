#!/usr/bin/env python3
"""Asks the real POV-Ray, with its own include files, for the values of tests/library/*.scene.

    regenerate.py [--write] [FILE.scene ...]
    regenerate.py --pictures [NAME ...]

The same as tests/lang/regenerate.py, for the files of this folder. With `--pictures` it draws pictures/NAME.pov, all without a
name, to 16-bit PNG files beside them.
"""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile

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


def draw(names):
    """Draws the pictures; the number of those that POV-Ray did not draw."""
    folder = HERE / "pictures"
    missing = 0
    for scene in sorted(folder.glob("*.pov")):
        if names and scene.stem not in names:
            continue
        command = ["povray", f"+I{scene}", f"+O{scene.with_suffix('.png')}", "+W48", "+H36", "+FN16", "-A", "-J", "-D"]
        # In a folder of its own, for what the scene writes.
        with tempfile.TemporaryDirectory() as elsewhere:
            done = subprocess.run(command, cwd=elsewhere, capture_output=True, timeout=120)
        if done.returncode:
            print(f"{scene.name}: POV-Ray fails")
            missing += 1
    return missing


if __name__ == "__main__":
    if "--pictures" in sys.argv:
        sys.exit(draw([name for name in sys.argv[1:] if name != "--pictures"]))
    sys.exit(lang.main())
