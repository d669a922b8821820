"""Writes `shell.ply`: a snail's shell, a tube that grows as it winds (Raup, Geometric analysis of shell coiling, 1966)."""

import math
import struct
import sys

AROUND, ALONG, TURNS = 18, 84, 4.5


def point(i, j):
    """Of ring i, place j: the tube grows by a fixed factor with each turn and comes down as it does; ribs run across it."""
    turn, side = TURNS * i / ALONG * math.tau, j / AROUND * math.tau
    size = math.exp(0.115 * (turn - TURNS * math.tau))
    rib = 1 + 0.06 * math.cos(9 * turn)
    out = size * (0.62 + 0.48 * rib * math.cos(side))
    return out * math.cos(turn), size * (0.6 * rib * math.sin(side) - 1.4) + 1.4, out * math.sin(turn)


def normal(i, j):
    step = 1e-4
    a = [q - p for p, q in zip(point(i - step, j), point(i + step, j))]
    b = [q - p for p, q in zip(point(i, j - step), point(i, j + step))]
    n = [b[1] * a[2] - b[2] * a[1], b[2] * a[0] - b[0] * a[2], b[0] * a[1] - b[1] * a[0]]
    length = math.hypot(*n)
    return [x / length for x in n]


with open(sys.argv[1] if len(sys.argv) > 1 else "shell.ply", "wb") as out:
    names = ["x", "y", "z", "nx", "ny", "nz", "u", "v"]
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {(ALONG + 1) * AROUND}"]
    head += [f"property float {name}" for name in names]
    head += [f"element face {ALONG * AROUND}", "property list uchar ushort vertex_indices", "end_header"]
    out.write(("\n".join(head) + "\n").encode())
    for i in range(ALONG + 1):
        for j in range(AROUND):
            out.write(struct.pack("<8f", *point(i, j), *normal(i, j), i / ALONG, j / AROUND))
    for i in range(ALONG):
        for j in range(AROUND):
            k = (j + 1) % AROUND
            out.write(struct.pack("<B4H", 4, i * AROUND + j, i * AROUND + k, (i + 1) * AROUND + k, (i + 1) * AROUND + j))
