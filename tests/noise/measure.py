#!/usr/bin/env python3
"""Asks the real POV-Ray for its noise.

    measure.py points    writes points.txt and turbulence.txt, with which tests/suite/noise.rs compares
    measure.py tables    finds the tables of src/math/noise/tables.rs anew, and prints whether they follow their rules

points.txt:      x y z, f_noise_generator 1 2 3, vturbulence(2, 0.5, 1, <x, y, z>)
turbulence.txt:  x y z lambda omega octaves, vturbulence(lambda, omega, octaves, <x, y, z>), and for each noise_generator the patterns
                 agate with these lambda, omega and octaves, granite, wrinkles

How the tables are found. Between lattice points, along an axis, every noise is a polynomial of degree 4; so five values give its value
and slope at the lattice point. Half the first component of `vturbulence` at whole numbers takes 256 values, the gradients take the
same (not halved), and value, gradient, next component's value ... follow one another in one chain of 267 entries. The place in
the chain is T[T[T[x']^y']^z'] & 255 where x' = (x + 10000) & 4095. Generator 3 has its lattice points at whole numbers minus
0.023157213, where it is 0.4925; its slopes there are 0.795 times a gradient of length 1, G[(P[(P[x'] + y') & 2047] + z') & 2047]
where x' = (x + 10000000) & 2047.
"""

import pathlib
import random
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
GENERATORS = ["str(f_noise_generator(P.x, P.y, P.z, %d), 0, 17)" % g for g in (1, 2, 3)]
VECTOR = 'vstr(3, vturbulence(2, 0.5, 1, P), " ", 0, 17)'
OFFSET = 10000000.023157213
# Found by climbing: here generators 2 and 3 leave the range from 0 to 1 most, and are cut.
EXTREMES = [
    [-1248.068, 2897.585, 1184.528],
    [-1569.006, 788.6, -2270.54],
    [578.336, -710.53, 2463.989],
    [-758.483, -1728.464, -2956.016],
    [-2523.676, -1790.261, 1607.596],
    [-2921.461, -802.45, -261.031],
    [408.563, -328.545, 1454.468],
    [2800.581, -1904.405, 668.453],
    [2418.475, -859.298, 1505.446],
    [1279.424, -1436.453, -2639.518],
    [2708.479, 2468.512, -1135.475],
    [-2722.503, 2537.505, 9.472],
]


def povray(points, expressions, before=""):
    """Numbers that POV-Ray prints for string expressions of the vector P, a row for each point."""
    write = ' " ", '.join(e + "," for e in expressions)
    macro = '#macro M(P) #write(Out, %s "\\n") #end\n' % write
    calls = "".join("M(<%r, %r, %r>)\n" % tuple(p) for p in points)
    scene = '#version 3.7;\n#include "functions.inc"\n%s\n#fopen Out "out.txt" write\n%s%s#fclose Out\ncamera { location 0 }\n'
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "a.pov").write_text(scene % (before, macro, calls))
        command = ["povray", "+Ia.pov", "+W1", "+H1", "-D", "-F", "-GA"]
        subprocess.run(command, cwd=folder, check=True, capture_output=True)
        return [[float(w) for w in line.split()] for line in open(folder + "/out.txt")]


def places(dice):
    """Everywhere, in and beside lattice planes of both kinds, and where the bounds of the range are reached."""
    anywhere = lambda size: [dice.uniform(-size, size) for _ in range(3)]
    points = [anywhere(size) for size in (3, 10, 100, 1e4, 1e6, 3e7, 1e9) for _ in range(100)]
    for shift in (0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-7, -1e-7, 0.5):
        for offset in (0, OFFSET - 1e7):
            for _ in range(18):
                p = anywhere(10)
                for axis in dice.sample(range(3), dice.randint(1, 3)):
                    p[axis] = dice.randint(-9, 9) - offset + shift
                points.append(p)
    return points + EXTREMES


def write(name, rows):
    with open(FOLDER / name, "w") as out:
        out.writelines(" ".join(repr(x) for x in row) + "\n" for row in rows)


def measure_points():
    points = places(random.Random(1971))
    write("points.txt", [p + row for p, row in zip(points, povray(points, GENERATORS + [VECTOR]))])
    dice, rows = random.Random(1972), []
    for _ in range(100):
        p = [dice.uniform(-30, 30) for _ in range(3)]
        words = (round(dice.uniform(1.2, 3.5), 2), round(dice.uniform(0.1, 0.9), 2), dice.randint(1, 10))
        row = p + list(words) + povray([p], ['vstr(3, vturbulence(%r, %r, %r, P), " ", 0, 17)' % words])[0]
        for generator in (1, 2, 3):
            patterns = ["agate lambda %r omega %r octaves %r" % words, "granite", "wrinkles"]
            declared = "".join("#declare F%d = function { pattern { %s } }\n" % f for f in enumerate(patterns))
            calls = ["str(F%d(P.x, P.y, P.z), 0, 17)" % i for i in range(3)]
            row += povray([p], calls, "global_settings { noise_generator %d }\n" % generator + declared)[0]
        rows.append(row)
    write("turbulence.txt", rows)


# The slope at 0 of the polynomial of degree 4 through the values at 0, 1/4, 1/2, 3/4, 1.
SLOPE = (-25 / 3, 16, -12, 16 / 3, -1)


def corners(lattice, expressions, offset=0.0):
    """For each lattice point and expression's number: value and gradient."""
    steps = [(axis, t) for axis in range(3) for t in (0, 0.25, 0.5, 0.75, 1)]
    shifted = lambda p, axis, t: [x - offset + (t if a == axis else 0) for a, x in enumerate(p)]
    rows = povray([shifted(p, *step) for p in lattice for step in steps], expressions)
    found = []
    for start in range(0, len(rows), 15):
        numbers = list(zip(*rows[start : start + 15]))
        slope = lambda n, axis: sum(w * v for w, v in zip(SLOPE, n[5 * axis : 5 * axis + 5]))
        found.append([(n[0], slope(n, 0), slope(n, 1), slope(n, 2)) for n in numbers])
    return found


def rand(state):
    """POV-Ray's random numbers of 15 bits."""
    while True:
        state = (state * 1812433253 + 12345) % 2**32
        yield state >> 16 & 0x7FFF


def find_entries():
    """The chain of values and gradients."""
    follows, firsts = {}, set()
    for x, y, z in corners([(i, 7, 11) for i in range(1500)], [VECTOR]):
        chain = ["%.6g" % (2 * n if i % 4 == 0 else n) for i, n in enumerate(x + y + z)]
        follows.update(zip(chain, chain[1:]))
        firsts.add(chain[0])
    entries = list(set(follows) - set(follows.values()))
    assert len(entries) == 1 and len(firsts) == 256
    while entries[-1] in follows:
        entries.append(follows[entries[-1]])
    return [float(e) for e in entries]


def check_hash(entries):
    """Does the shuffled table tell the value at each of many lattice points?"""
    table, numbers = list(range(4096)), rand(0)
    for i in range(4095, -1, -1):
        j = next(numbers) % 4096
        table[i], table[j] = table[j], table[i]
    dice = random.Random(2)
    points = [[dice.randint(-9999, 9999) for _ in range(3)] for _ in range(20000)]
    points += [[i if a == axis else 0 for a in range(3)] for axis in range(3) for i in range(4096)]
    wrong = 0
    for (x, y, z), row in zip(points, povray(points, [VECTOR])):
        h = table[table[table[(x + 10000) & 4095] ^ (y + 10000) & 4095] ^ (z + 10000) & 4095] & 255
        wrong += any(abs(2 * row[c] - entries[h + 4 * c]) > 1e-9 for c in range(3))
    return wrong


def check_gradients():
    """Largest error of the gradients of generator 3 on the three axes and at random lattice points."""
    gradients, numbers = [], rand(1)
    while len(gradients) < 2048:
        v = [next(numbers) % 4096 / 2048 - 1 for _ in range(3)]
        length = sum(x * x for x in v) ** 0.5
        if length <= 1:
            gradients.append([x / length for x in v])
    table = list(range(2048)) + [0]
    for i in range(2048, 0, -2):
        j = next(numbers) % 2048
        table[i], table[j] = table[j], table[i]
    dice = random.Random(3)
    points = [[dice.randint(-9999, 9999) for _ in range(3)] for _ in range(3000)]
    points += [[i if a == axis else 0 for a in range(3)] for axis in range(3) for i in range(2048)]
    worst = 0.0
    for (x, y, z), [(value, *slopes)] in zip(points, corners(points, GENERATORS[2:], OFFSET - 1e7)):
        x, y, z = x + 10**7, y + 10**7, z + 10**7
        expected = gradients[(table[(table[x & 2047] + y) & 2047] + z) & 2047]
        errors = [abs(s / 0.795 - e) for s, e in zip(slopes, expected)]
        worst = max(worst, abs(value - 0.4925), *errors)
    return worst


def measure_tables():
    entries = find_entries()
    rounded = [float("%.6g" % (round((e + 1) / 2 * 65535) * 2 / 65535 - 1)) for e in entries]
    print("entries:", entries)
    print("entries that are not multiples of 2/65535:", sum(a != b for a, b in zip(entries, rounded)))
    print("lattice points where the hash is wrong:", check_hash(entries))
    print("largest error of a gradient of generator 3:", check_gradients())


if __name__ == "__main__":
    actions = {"points": measure_points, "tables": measure_tables}
    if len(sys.argv) != 2 or sys.argv[1] not in actions:
        sys.exit(__doc__)
    actions[sys.argv[1]]()
