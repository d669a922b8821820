#!/usr/bin/env python3
"""Asks POV-Ray 3.7 for the pixels of light cases.

    regenerate.py NAME...          writes NAME.json anew
    regenerate.py --check [NAME...]  compares instead, by default all; exit code 1 where POV-Ray gives others

A case NAME.pov is drawn at 16x12 without anti-aliasing, with gamma 1 and 16 bits; NAME_qN.pov with +QN. NAME.json holds the numbers row
by row, three a pixel, in steps of 1/65535. A case whose first line is `// options: +A0.0 +AM2 +R2` is drawn with these options of anti-aliasing.
"""

import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SIZE = (16, 12)


def drawn(name):
    """POV-Ray's steps for a case."""
    quality = re.search(r"_q(\d+)$", name)
    options = re.match(r"// options: (.*)", (HERE / f"{name}.pov").read_text(errors="replace"))
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.ppm"
        words = [f"+I{name}.pov", f"+O{out}", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-A", "-J", "-D", "-GA", "File_Gamma=1.0", "+FP16"]
        subprocess.run(["povray", *words, *([f"+Q{quality[1]}"] if quality else []), *(options[1].split() if options else [])], cwd=HERE, check=True, capture_output=True)
        # The pixels stand behind a head of lines of any number.
        bytes_ = out.read_bytes()[-6 * SIZE[0] * SIZE[1]:]
    return [bytes_[i] << 8 | bytes_[i + 1] for i in range(0, len(bytes_), 2)]


def stored(name):
    """The steps in NAME.json, which may also be a list of pixels."""
    kept = json.loads((HERE / f"{name}.json").read_text())
    if isinstance(kept[0], int):
        return kept
    steps = [0] * (3 * SIZE[0] * SIZE[1])
    for pixel in kept:
        at = 3 * (pixel["y"] * SIZE[0] + pixel["x"])
        steps[at:at + 3] = [round(c * 65535) for c in pixel["rgb"]]
    return steps


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    names = options.names or (sorted(path.stem for path in HERE.glob("*.pov")) if options.check else [])
    differ = 0
    # (POV-Ray sleeps most of the time that it takes for a small picture.)
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        pictures = pool.map(drawn, names)
    for name, steps in zip(names, pictures):
        if not options.check:
            (HERE / f"{name}.json").write_text(json.dumps(steps, separators=(",", ":")) + "\n")
        elif max(abs(a - b) for a, b in zip(steps, stored(name))) > 1:
            differ += 1
            print(f"{name}: POV-Ray gives other numbers")
    print(f"{len(names)} cases, {differ} differ")
    return 1 if differ else 0


if __name__ == "__main__":
    raise SystemExit(main())
