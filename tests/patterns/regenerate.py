#!/usr/bin/env python3
"""Asks the real POV-Ray for its patterns at random points.

    regenerate.py [--points N] [--to FOLDER] [SECTION...]    writes SECTION.txt for each (or every) section of settings.txt
    regenerate.py --check [SECTION...]                       compares with what is there instead; exit code 1 if it differs

settings.txt: a section begins with `== name`; each other line is a setting. `//` begins a comment. A setting is
- what stands between the braces of `pattern { }`; what stands before a `|` goes into `global_settings { }`,
- or `pigment` and what stands between the braces of `pigment { }`: its red is asked, which POV-Ray keeps in single precision,
- or `picture` and an object: it is drawn with a camera and a lamp that stay the same.

SECTION.txt, which tests/cases/patterns.rs compares with durer: `# setting`, then a line `x y z value` for each point, or a line `column row value`
for each pixel, with the value counted in 65535ths. A section has N points, 1000 unless said otherwise, shared by its settings; but each
setting has 60 at least, and each picture 1200. Points are those of the setting's own dice, so adding settings leaves the places in the
others' tables as they are.

voxels.df3 and colors.ppm, which some settings read, are written too. Needs `povray` 3.7.
"""

import argparse
import concurrent.futures
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
WIDTH, HEIGHT = 40, 30
STAGE = "camera { location <0, 0, -6> look_at 0 angle 50 } light_source { <-4, 6, -9>, 1 }"


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
    """Near the origin and far from it, some in the planes of whole and half numbers; not so in tilings, where those are joints of equal tiles."""
    dice = random.Random(setting)
    tiling = setting.startswith("pigment tiling")
    rows = []
    for i in range(count):
        size, digits = [(1, 3), (3, 3), (3, 3), (12, 2), (200, 2), (20000, 1)][i % 6]
        p = [round(dice.uniform(-size, size), 4 if tiling else digits) for _ in range(3)]
        if i % 5 == 4 and not tiling:
            for axis in dice.sample(range(3), dice.randint(1, 3)):
                p[axis] = round(2 * p[axis]) / 2
        rows.append(p)
    return rows


def run(scene, words, output):
    """What POV-Ray writes to a file."""
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "q.pov").write_text(scene)
        command = "povray +Iq.pov -D -GA +WT1".split() + ["+L" + str(HERE)] + words
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit("%s\n%s" % (scene[:1000], done.stderr[-2000:]))
        return pathlib.Path(folder, output).read_bytes()


def numbers(setting, rows):
    """The numbers of a setting's pattern, as POV-Ray prints them."""
    what, red = ("pigment { %s }" % setting[8:], ".red") if setting.startswith("pigment ") else (None, "")
    settings, _, pattern = setting.rpartition("|") if what is None else ("", "", "")
    lines = ["#version 3.7;", "global_settings { assumed_gamma 1 %s }" % settings, '#fopen Out "out.txt" write']
    lines.append("#declare F = function { %s }" % (what or "pattern { %s }" % pattern))
    lines += ['#write (Out, str(F(%r, %r, %r)%s, 0, 17), "\\n")' % (*p, red) for p in rows]
    text = run("\n".join(lines + ["#fclose Out\n"]), "+W1 +H1 -F".split(), "out.txt")
    return [float(line) for line in text.split()]


def pixels(setting):
    """The red of each pixel of a picture."""
    scene = "#version 3.7; global_settings { assumed_gamma 1 }\n%s\n%s\n" % (STAGE, setting[8:])
    words = ["+W%d" % WIDTH, "+H%d" % HEIGHT, "-A", "+FP16", "+Oout.ppm", "File_Gamma=1"]
    data = run(scene, words, "out.ppm")[-6 * WIDTH * HEIGHT :]
    return [256 * data[i] + data[i + 1] for i in range(0, len(data), 6)]


def table(setting, count):
    """The lines of a setting: its own, and one for each point or pixel."""
    if setting.startswith("picture "):
        rows = [(i % WIDTH, i // WIDTH) for i in range(WIDTH * HEIGHT)]
        values = pixels(setting)
    else:
        rows = points(setting, count)
        values = numbers(setting, rows)
    digits = 8 if setting.startswith("pigment ") else 12
    lines = ["%s %.*g\n" % (" ".join("%.12g" % x for x in row), digits, value) for row, value in zip(rows, values)]
    return "# %s\n" % setting + "".join(lines)


def write_voxels():
    """8 by 5 by 6 numbers of one byte."""
    dice = random.Random("voxels")
    size = bytes([0, 8, 0, 5, 0, 6])
    (HERE / "voxels.df3").write_bytes(size + bytes(dice.randrange(256) for _ in range(8 * 5 * 6)))


def write_colors():
    """7 by 5 pixels."""
    dice = random.Random("colors")
    (HERE / "colors.ppm").write_bytes(b"P6\n7 5\n255\n" + bytes(dice.randrange(256) for _ in range(7 * 5 * 3)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=1000)
    parser.add_argument("--to", type=pathlib.Path, default=HERE)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("sections", nargs="*")
    arguments = parser.parse_args()
    if arguments.check:
        with tempfile.TemporaryDirectory() as folder:
            arguments.to = pathlib.Path(folder)
            write(arguments)
            written = sorted(arguments.to.glob("*.txt"))
            other = [new.name for new in written if new.read_bytes() != (HERE / new.name).read_bytes()]
        print("%d files, %d differences %s" % (len(written), len(other), " ".join(other)))
        sys.exit(bool(other))
    write(arguments)


def write(arguments):
    write_voxels()
    write_colors()
    for name, settings in sections().items():
        if arguments.sections and name not in arguments.sections:
            continue
        count = max(60, -(-arguments.points // len(settings)))
        # (POV-Ray sleeps most of the time that it takes for so little.)
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            tables = list(pool.map(lambda setting: table(setting, count), settings))
        (arguments.to / (name + ".txt")).write_text("".join(tables))


main()
