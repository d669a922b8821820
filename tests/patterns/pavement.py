#!/usr/bin/env python3
"""Asks the real POV-Ray for its pavements. Needs numpy.

    pavement.py table    writes pavement.txt, with which src/pattern/pavement/mod.rs compares:
                         sides tiles pattern exterior interior form x z value
    pavement.py plans    finds src/pattern/pavement/plans.rs anew: which cells of the grid are joined, and after how many steps it repeats
                         (then: cargo fmt)

How the plans are found. Just inside the middle of each edge of a cell the pattern has one value if there is a joint, and another if the
tile goes on. So a piece of 26 by 26 cells gives a mask of edges for each cell; its periods are the smallest steps that carry it into itself.
"""
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parent
PLANS = FOLDER.parents[1] / "src/pattern/pavement/plans.rs"
H = math.sqrt(3) / 2
# How many patterns there are for 1, 2, 3 … tiles.
COUNT = {3: [1, 1, 1, 3, 4, 12], 4: [1, 1, 2, 5, 12, 35], 6: [1, 1, 3, 7, 22]}
SIZE = 26


def pavement(sides, tiles, pattern, more=""):
    return f"pavement number_of_sides {sides} number_of_tiles {tiles} pattern {pattern} {more}"


def sample(pigment, points, offsets):
    """Values of the pigment, [points, offsets], on the plane y = 0.3."""
    vectors = lambda list: ",".join("<%.15g,%.15g>" % v for v in list)
    lines = [
        "#version 3.7; global_settings { assumed_gamma 1 }",
        '#fopen Out "s.txt" write',
        "#declare F = function { pigment { %s color_map { [0 rgb 0] [1 rgb 1] } } }" % pigment,
        "#declare B = array[%d] { %s }" % (len(points), vectors(points)),
        "#declare O = array[%d] { %s }" % (len(offsets), vectors(offsets)),
        "#for (I, 0, %d) #for (J, 0, %d)" % (len(points) - 1, len(offsets) - 1),
        '#declare Q = B[I] + O[J]; #write (Out, str(F(Q.u, 0.3, Q.v).red, 0, 7), "\\n")',
        "#end #end #fclose Out",
    ]
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "s.pov").write_text("\n".join(lines))
        run = subprocess.run("povray +Is.pov +W1 +H1 -D -F +WT1".split(), cwd=folder, capture_output=True, text=True)
        if run.returncode:
            raise SystemExit(run.stderr[-1500:])
        return np.loadtxt(pathlib.Path(folder, "s.txt")).reshape(len(points), len(offsets))


def table():
    rnd = random.Random(7)
    out = []
    for sides, counts in COUNT.items():
        for tiles, count in enumerate(counts, 1):
            for pattern in [p for p in range(1, count + 1) for _ in range(2)]:
                looks = rnd.randrange(3), rnd.randrange(3), rnd.randrange(4)
                if rnd.random() < 0.05:
                    looks = rnd.choice([255, -2, 4]), rnd.choice([257, -1, 5]), rnd.choice([-1, -2, 257, 7])
                points = [tuple(round(rnd.uniform(-q, q), 3) for _ in (0, 1)) for q in [3, 3, 3, 3, 8, 8, 8, 40]]
                values = sample(pavement(sides, tiles, pattern, "exterior %d interior %d form %d" % looks), points, [(0, 0)])
                for (x, z), value in zip(points, values[:, 0]):
                    out.append("%d %d %d %d %d %d %.15g %.15g %.7g" % (sides, tiles, pattern, *looks, x, z, value))
    (FOLDER / "pavement.txt").write_text("\n".join(out) + "\n")


class Grid:
    """Kinds of cells: centre, corners against the clock, and the neighbour behind each edge (steps along both axes, kind)."""

    def __init__(self, sides):
        if sides == 4:
            self.kinds = [((0.5, 0.5), [(0, 0), (1, 0), (1, 1), (0, 1)])]
            self.axes, self.depth = ((1, 0), (0, 1)), 0.5
        elif sides == 6:
            around = [(math.cos(k * math.pi / 3), math.sin(k * math.pi / 3)) for k in range(6)]
            self.kinds = [((1.0, 0.0), [(1 + x, z) for x, z in around])]
            self.axes, self.depth = ((1.5, H), (0, 2 * H)), H / 3
        else:
            up = ((0.5, H / 3), [(0, 0), (1, 0), (0.5, H)])
            self.kinds = [up, ((1.0, 2 * H / 3), [(0.5, H), (1, 0), (1.5, H)])]
            self.axes, self.depth = ((1, 0), (0.5, H)), H / 3
        self.sides = sides
        self.cells = [(i, j, k) for j in range(SIZE) for i in range(SIZE) for k in range(len(self.kinds))]

    def origin(self, cell):
        (ax, az), (bx, bz) = self.axes
        return cell[0] * ax + cell[1] * bx, cell[0] * az + cell[1] * bz

    def masks(self, pigment):
        """For each cell 1 where its edge is a joint."""
        out = {}
        for kind, (centre, corners) in enumerate(self.kinds):
            cells = [cell for cell in self.cells if cell[2] == kind]
            offsets = []
            for edge in range(self.sides):
                (ax, az), (bx, bz) = corners[edge], corners[(edge + 1) % self.sides]
                dx, dz = centre[0] - (ax + bx) / 2, centre[1] - (az + bz) / 2
                length = math.hypot(dx, dz)
                # two places just inside the edge, which must agree
                for t in (0.5, 0.45):
                    offsets.append((ax + (bx - ax) * t + dx / length * 0.02, az + (bz - az) * t + dz / length * 0.02))
            values = sample(pigment, [self.origin(cell) for cell in cells], offsets)
            joint = abs(values - (1 - 0.02 / self.depth)) < 2e-4
            for cell, row in zip(cells, joint):
                assert (row[0::2] == row[1::2]).all(), (pigment, cell, row)
                out[cell] = tuple(int(x) for x in row[0::2])
        return out


def period(masks):
    """(a, b, c): it repeats after a steps along the first axis, and after b along the first and c along the second."""

    def same(di, dj):
        moved = (((i + di, j + dj, k), mask) for (i, j, k), mask in masks.items())
        return all(masks[cell] == mask for cell, mask in moved if cell in masks)

    a = next(d for d in range(1, 20) if same(d, 0))
    return next((a, b, c) for c in range(1, 14) for b in range(a) if same(b, c))


def plans():
    head = PLANS.read_text().split("/// Tiles of")[0]
    out = [head.rstrip() + "\n"]
    for sides, name, last in ((3, "TRIANGLES", "6 triangles"), (4, "SQUARES", "6 squares"), (6, "HEXAGONS", "5 hexagons")):
        grid = Grid(sides)
        out.append(f"/// Tiles of 1 to {last}.\npub const {name}: &[&[&str]] = &[")
        for tiles, count in enumerate(COUNT[sides], 1):
            rows = []
            for pattern in range(1, count + 1):
                masks = grid.masks(pavement(sides, tiles, pattern))
                a, b, c = period(masks)
                cells = [masks[i, j, k] for j in range(c) for i in range(a) for k in range(len(grid.kinds))]
                digits = [sum(bit << k for k, bit in enumerate(mask)) for mask in cells]
                row = "".join(("%02o" if sides == 6 else "%x") % digit for digit in digits)
                rows.append(f'"{a} {b} {c} {row}"')
            out.append("    &[%s]," % ", ".join(rows))
        out.append("];\n")
    PLANS.write_text("\n".join(out))


if __name__ == "__main__":
    {"table": table, "plans": plans}[sys.argv[1]]()
