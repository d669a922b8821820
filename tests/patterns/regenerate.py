#!/usr/bin/env python3
"""Asks the real POV-Ray for its patterns at random points.

    regenerate.py [--points N] [--to FOLDER] [SECTION...]    writes SECTION.txt for each (or every) section of settings.txt

settings.txt: a section begins with `== name`; each other line is a setting: what stands between the braces of `pattern { }`. What
stands before a `|` goes into `global_settings { }`. `//` begins a comment.

SECTION.txt, which tests/patterns.rs compares with durer: `# setting`, then a line `x y z value` for each point. Points are those of the
setting's own dice, so adding settings leaves the others' tables as they are. Needs `povray` 3.7.
"""

import argparse
import pathlib
import random
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def sections():
    """The settings of each section."""
    found = {}
    for line in (HERE / "settings.txt").read_text().splitlines():
        line = line.split("//")[0].strip()
        if line.startswith("=="):
            settings = found.setdefault(line[2:].strip(), [])
        elif line:
            settings.append(line)
    return found


def points(setting, count):
    """Near the origin and far from it, some in the planes of whole and half numbers."""
    dice = random.Random(setting)
    rows = []
    for i in range(count):
        size, digits = [(1, 4), (3, 4), (3, 4), (12, 3), (200, 3), (20000, 2)][i % 6]
        p = [round(dice.uniform(-size, size), digits) for _ in range(3)]
        if i % 5 == 4:
            for axis in dice.sample(range(3), dice.randint(1, 3)):
                p[axis] = round(2 * p[axis]) / 2
        rows.append(p)
    return rows


def povray(setting, rows):
    """The numbers of a setting's pattern, as POV-Ray prints them."""
    settings, _, pattern = setting.rpartition("|")
    lines = ["#version 3.7;", "global_settings { assumed_gamma 1 %s }" % settings, '#fopen Out "out.txt" write']
    lines.append("#declare F = function { pattern { %s } }" % pattern)
    lines += ['#write (Out, str(F(%r, %r, %r), 0, 17), "\\n")' % tuple(p) for p in rows]
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "q.pov").write_text("\n".join(lines + ["#fclose Out\n"]))
        run = subprocess.run("povray +Iq.pov +W1 +H1 -D -F -GA +WT1".split(), cwd=folder, capture_output=True, text=True)
        if run.returncode != 0:
            raise SystemExit("%s\n%s" % (setting, run.stderr[-2000:]))
        return [repr(float(line)) for line in open(folder + "/out.txt")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=60)
    parser.add_argument("--to", type=pathlib.Path, default=HERE)
    parser.add_argument("sections", nargs="*")
    arguments = parser.parse_args()
    for name, settings in sections().items():
        if arguments.sections and name not in arguments.sections:
            continue
        with open(arguments.to / (name + ".txt"), "w") as out:
            for setting in settings:
                rows = points(setting, arguments.points)
                out.write("# %s\n" % setting)
                for p, value in zip(rows, povray(setting, rows)):
                    out.write("%s %s\n" % (" ".join("%g" % x if x == float("%g" % x) else repr(x) for x in p), value))


main()
