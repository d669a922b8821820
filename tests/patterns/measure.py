#!/usr/bin/env python3
"""Finds the random numbers behind some patterns anew, from what POV-Ray prints (needs numpy).

    measure.py waves    sources of `ripples`, and the frequencies of `waves`
    measure.py cells    the number of each hash in `cells`, and the points of `crackle`

How sources are found. With a frequency f near 0, `ripples` is 1/2 + f pi/10 times the sum of the distances to the 10 sources. The Laplacian of a
distance r is 2/r: so the sources lie where it is largest, and least squares finds their places to 15 digits. All have length 1, and each is the
vector noise at a lattice point. In `waves`, source i has the weight 1/F(i) and the frequency F(i); the sines' third powers of f tell F(i).
"""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "noise"))
import measure as noise  # noqa: E402


def ask(pattern, points):
    lines = ["#version 3.7;", "global_settings { assumed_gamma 1 }", '#fopen Out "out.txt" write']
    lines.append("#declare F = function { pattern { %s } }" % pattern)
    lines += ['#write (Out, str(F(%r, %r, %r), 0, 17), "\\n")' % tuple(map(float, p)) for p in points]
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "q.pov").write_text("\n".join(lines + ["#fclose Out\n"]))
        subprocess.run("povray +Iq.pov +W1 +H1 -D -F -GA".split(), cwd=folder, check=True, capture_output=True)
        return np.loadtxt(folder + "/out.txt")


def fit(residual, x):
    """Least squares by Levenberg and Marquardt."""
    damping, r = 1e-3, residual(x)
    for _ in range(100):
        steps = 1e-7 * np.maximum(1, abs(x))
        columns = [(residual(x + s * e) - residual(x - s * e)) / (2 * s) for s, e in zip(steps, np.eye(len(x)))]
        jacobian = np.array(columns).T
        square, slope = jacobian.T @ jacobian, jacobian.T @ r
        while damping < 1e9:
            step = np.linalg.solve(square + damping * np.diag(np.diag(square) + 1e-12), -slope)
            tried = residual(x + step)
            if tried @ tried < r @ r:
                x, r, damping = x + step, tried, damping / 5
                break
            damping *= 4
        if damping >= 1e9 or r @ r < 1e-26:
            break
    return x, r @ r


def places():
    """Of the 10 sources, in no order."""
    f, side, step = 1 / 16, np.linspace(-1.2, 1.2, 25), 0.02
    grid = np.stack(np.meshgrid(side, side, side, indexing="ij"), -1).reshape(-1, 3) + 0.0123
    around = np.concatenate([np.zeros((1, 3)), np.eye(3) * step, -np.eye(3) * step])
    v = ask("ripples frequency %r" % f, (grid[:, None] + around).reshape(-1, 3)).reshape(-1, 7)
    laplacian = (v[:, 1:].sum(1) - 6 * v[:, 0]).reshape(25, 25, 25)
    box = lambda i, j, k: laplacian[i - 1 : i + 2, j - 1 : j + 2, k - 1 : k + 2]
    peaks = [p for p in np.ndindex(25, 25, 25) if 0 < min(p) and max(p) < 24 and laplacian[p] == box(*p).max()]
    found = np.array([[side[i] for i in p] for p in sorted(peaks, key=lambda p: -laplacian[p])[:9]])
    found /= np.linalg.norm(found, axis=1)[:, None]

    # The tenth lies beside one of the nine.
    points = np.random.default_rng(3).uniform(-4, 4, (900, 3))
    values = ask("ripples frequency %r" % f, points) / f - 0.5
    distances = lambda x: np.linalg.norm(points[:, None] - x.reshape(10, 3), axis=2)
    residual = lambda x: 0.05 * np.sin(2 * np.pi * f * distances(x)).sum(1) - values
    starts = [np.concatenate([found, [near * 0.98 + 0.1]]).ravel() for near in found]
    best = min((fit(residual, start) for start in starts), key=lambda found: found[1])
    return best[0].reshape(10, 3)


def measure_waves():
    sources = places()
    print("lengths:", np.linalg.norm(sources, axis=1))
    points = np.random.default_rng(4).uniform(-4, 4, (900, 3))
    r = np.linalg.norm(points[:, None] - sources, axis=2)
    small, f = 2.0**-10, 0.25
    values = (ask("waves frequency %r" % small, points) / small - 0.5) / small
    cubes = np.linalg.lstsq(np.concatenate([r, r**3, r**5], 1), values, rcond=None)[0][10:20] / small**2
    start = np.sqrt(abs(6 * cubes / 0.04 / np.pi)) / 2 / np.pi
    values = ask("waves frequency %r" % f, points) / f - 0.5
    frequencies, error = fit(lambda x: (0.02 * np.sin(2 * np.pi * f * x * r) / x).sum(1) - values, start)
    print("error:", error, "random numbers:", (frequencies - 0.01) * 32767)

    # The rule: noise at <i, 0, 0>, and POV-Ray's stream from 1 behind its first 7168 numbers.
    stream = noise.rand(1)
    wanted = [next(stream) for _ in range(7178)][7168:]
    vectors = np.array(noise.povray([(i, 0, 0) for i in range(10)], [noise.VECTOR]))
    vectors /= np.linalg.norm(vectors, axis=1)[:, None]
    order = [int(abs(sources - v).sum(1).argmin()) for v in vectors]
    print("places differ by", abs(sources[order] - vectors).max())
    print("numbers differ by", abs((frequencies[order] - 0.01) * 32767 - wanted).max())


def twister(count):
    """MT19937 from seed 5489."""
    bits = np.random.RandomState(5489)
    return bits.randint(0, 2**32, count, dtype=np.uint64).astype(float) / 2**32


def measure_cells():
    table, numbers = list(range(4096)), noise.rand(0)
    for i in range(4095, -1, -1):
        j = next(numbers) % 4096
        table[i], table[j] = table[j], table[i]
    table, random = np.array(table), twister(4098)
    cubes = np.random.default_rng(5).integers(-9999, 9999, (20000, 3))
    hashes = table[table[table[cubes[:, 0] & 4095] ^ cubes[:, 1] & 4095] ^ cubes[:, 2] & 4095]
    values = ask("cells", cubes + 0.5)
    print("hashes seen:", len(set(hashes)), "numbers:", len(set(values)))
    print("cells differ by", abs(values - random[hashes]).max())
    sites = cubes + np.stack([random[hashes + i] for i in range(3)], 1)
    print("crackle at its points, at most", ask("crackle form x", sites[:5000]).max())


if __name__ == "__main__":
    actions = {"waves": measure_waves, "cells": measure_cells}
    if len(sys.argv) != 2 or sys.argv[1] not in actions:
        sys.exit(__doc__)
    actions[sys.argv[1]]()
