#!/usr/bin/env python3
"""Computes correctly rounded values of transcendental functions, for the test of src/math/fp.

    regenerate.py [--check]        (needs the package mpmath)

Writes known_values.txt: a line has the name of a function, the bits of its arguments and the bits of its value, in hexadecimal.
With `--check` it compares, and writes nothing.
"""
import pathlib, random, struct, sys

from mpmath import mp, mpf

mp.prec = 300
HERE = pathlib.Path(__file__).resolve().parent
PER_RANGE = 40

# For each function, the ranges that its arguments are drawn from.
ONE = {
    "sin": [(-4, 4), (-1e3, 1e3), (-1e9, 1e9), (-1e-5, 1e-5)],
    "cos": [(-4, 4), (-1e3, 1e3), (-1e9, 1e9), (-1e-5, 1e-5)],
    "tan": [(-4, 4), (-1e3, 1e3), (-1e9, 1e9), (-1e-5, 1e-5)],
    "asin": [(-1, 1), (-1e-5, 1e-5), (0.999, 1)],
    "acos": [(-1, 1), (-1e-5, 1e-5), (0.999, 1)],
    "atan": [(-4, 4), (-1e6, 1e6), (-1e-5, 1e-5)],
    "exp": [(-1, 1), (-700, 700), (-1e-5, 1e-5)],
    "exp2": [(-1, 1), (-1000, 1000), (-1e-5, 1e-5)],
    "ln": [(0, 2), (0.999, 1.001), (0, 1e300)],
    "log10": [(0, 2), (0.999, 1.001), (0, 1e300)],
    "cbrt": [(-2, 2), (-1e300, 1e300), (-1e-300, 1e-300)],
    "sinh": [(-4, 4), (-700, 700), (-1e-5, 1e-5)],
    "cosh": [(-4, 4), (-700, 700), (-1e-5, 1e-5)],
    "tanh": [(-4, 4), (-1e-5, 1e-5)],
    "asinh": [(-4, 4), (-1e6, 1e6), (-1e-5, 1e-5)],
    "acosh": [(1, 4), (1, 1e6)],
    "atanh": [(-1, 1), (-1e-5, 1e-5)],
}
TWO = {
    "atan2": [((-2, 2), (-2, 2)), ((-1e-5, 1e-5), (-2, 2)), ((-2, 2), (-1e-9, 1e-9))],
    "hypot": [((-2, 2), (-2, 2)), ((-1e200, 1e200), (-1e200, 1e200)), ((-1e-200, 1e-200), (-1e-200, 1e-200))],
    "pow": [((0, 1), (0, 4)), ((0, 2), (-20, 20)), ((0.99, 1.01), (-9e3, 9e3)), ((0, 1e300), (-1, 1)), ((0.5, 2), (-690, 690))],
}
EXACT = {"ln": mp.log, "log10": mp.log10, "exp2": lambda x: mpf(2) ** x, "cbrt": lambda x: mp.sign(x) * mp.cbrt(abs(x)), "pow": mp.power}


def bits(value):
    return struct.pack(">d", float(value)).hex()


def text():
    draw = random.Random(1525)
    out = ["# Made by regenerate.py: a function, the bits of its arguments, and those of its correctly rounded value."]
    for name, ranges in {**ONE, **TWO}.items():
        exact = EXACT.get(name) or getattr(mp, name)
        for each in ranges:
            for _ in range(PER_RANGE):
                arguments = [draw.uniform(*span) for span in (each if name in TWO else [each])]
                out.append(" ".join([name, *map(bits, arguments), bits(exact(*map(mpf, arguments)))]))
    return "\n".join(out) + "\n"


def main():
    file = HERE / "known_values.txt"
    if "--check" in sys.argv:
        sys.exit(0 if file.read_text() == text() else f"{file} differs from what regenerate.py computes")
    file.write_text(text())


if __name__ == "__main__":
    main()
