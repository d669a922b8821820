#!/usr/bin/env python3
"""What durer and the installed POV-Ray say about the same mistakes, one above the other. POV-Ray's words are not kept anywhere.

    compare.py [--durer PROGRAM] [NAME ...]     without names: all tests/ui/mistake_*.scene

Without a built program at `--durer`, what durer says is taken from the `.stderr` files.
"""

import argparse
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
# POV-Ray quotes the last lines that it read, and says between them what is wrong.
SAYS = re.compile(r"Parse (Error|Warning)|[Ee]rror:|[Ww]arning:|Cannot|Expected|not found")


def ask_povray(scene):
    """What POV-Ray complains of: its lines that say something."""
    with tempfile.TemporaryDirectory() as elsewhere:
        command = ["povray", f"+I{scene}", f"+O{elsewhere}/out.png", "-D", "-V", "+W8", "+H6", "-GD", "-GR", "-GS"]
        command.append(f"+L{HERE}")
        done = subprocess.run(command, cwd=elsewhere, capture_output=True, timeout=60)
    text = done.stderr.decode("latin-1") + done.stdout.decode("latin-1")
    lines = [line.strip() for line in text.splitlines()]
    start = next((i for i, line in enumerate(lines) if SAYS.search(line)), None)
    said = [] if start is None else [line for line in lines[start:] if line and "Fatal error" not in line]
    return said, done.returncode


def ask_durer(program, scene):
    if program is None:
        return scene.with_suffix(".stderr").read_text(encoding="utf-8")
    done = subprocess.run([program, "check", scene.name], cwd=scene.parent, capture_output=True, timeout=60)
    return done.stderr.decode("utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--durer", default=None)
    options = parser.parse_args()
    scenes = sorted(HERE.glob("mistake_*.scene"))
    if options.names:
        scenes = [HERE / f"{pathlib.Path(name).stem}.scene" for name in options.names]
    for scene in scenes:
        said, code = ask_povray(scene)
        print(f"{'=' * 110}\n{scene.name}\n{scene.read_text(encoding='utf-8').rstrip()}")
        print(f"---- POV-Ray (exit {code})")
        print("\n".join(said) or "nothing")
        print("---- durer")
        print(ask_durer(options.durer, scene).rstrip())
    print(f"{len(scenes)} mistakes")


if __name__ == "__main__":
    main()
