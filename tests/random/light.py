#!/usr/bin/env python3
"""Draws random scenes with radiosity or photons with POV-Ray and durer, and compares their light.

    light.py --durer PATH [--seed N] [--count N] [--keep DIR]

Both programs gather and emit light by random numbers of their own, so that single pixels differ by noise. Compared are the mean of
the picture, and the pictures blurred by a Gaussian of 3 pixels: their difference (root of the mean square) relative to the mean.
`--keep` keeps each scene with both pictures. Fails if a scene is refused, or if more than one in ten differs by more than the limits
below.
"""
import argparse, concurrent.futures, os, pathlib, random, subprocess, sys, tempfile

import numpy
from PIL import Image

SIZE = (80, 60)
# Maximum relative differences of the mean and of the blurred pictures.
LIMITS = (0.03, 0.06)


class Scenes:
    """A random scene: a room or an open place, some objects, and light."""

    def __init__(self, seed):
        self.r = random.Random(seed)
        self.kind = self.r.choice(["radiosity", "photons", "both"])

    def f(self, a, b):
        return round(self.r.uniform(a, b), 3)

    def color(self, least=0.1, most=0.9):
        return f"rgb <{self.f(least, most)}, {self.f(least, most)}, {self.f(least, most)}>"

    def place(self):
        return f"<{self.f(-1.6, 1.6)}, {self.f(0.4, 1.6)}, {self.f(-1, 1.5)}>"

    def settings(self):
        out = ""
        if self.kind != "photons":
            out += (f"radiosity {{ count {self.r.choice([150, 250, 400])} error_bound {self.f(0.3, 0.7)} recursion_limit {self.r.choice([1, 2, 3])} "
                    f"nearest_count {self.r.choice([4, 5, 8])} pretrace_start 0.08 pretrace_end 0.02 low_error_factor {self.f(0.4, 0.8)} ")
            out += self.r.choice(["", "", f"gray_threshold {self.f(0, 0.6)} "]) + self.r.choice(["", "", f"brightness {self.f(0.7, 1.3)} "])
            out += self.r.choice(["", "normal on "]) + self.r.choice(["", "always_sample off "]) + "} "
        if self.kind != "radiosity":
            out += f"photons {{ spacing {self.f(0.012, 0.02)} " + self.r.choice(["", "autostop 0 ", "jitter 0.4 "]) + self.r.choice(["", "gather 20, 100 "]) + "} "
        return out

    def light(self):
        place = f"<{self.f(-1.5, 1.5)}, {self.f(2.9, 3.3)}, {self.f(-1.5, 1)}>"
        form = self.r.choice(["", "", f"spotlight point_at <0, 0.5, 0> radius {self.f(20, 30)} falloff {self.f(35, 50)}",
                              "area_light 0.4*x, 0.4*z, 3, 3", "fade_distance 3 fade_power 2"])
        area = " area_light" if "area_light" in form and self.kind != "radiosity" else ""
        photons = "photons { reflection on refraction on%s }" % area if self.kind != "radiosity" else ""
        return f"light_source {{ {place} rgb {self.f(0.7, 1.3)} {form} {photons} }}"

    def surroundings(self):
        if self.r.random() < 0.6:
            walls = f"""box {{ <-2.5, 0, -4>, <2.5, 3.5, 2.5> inverse pigment {{ {self.color(0.4)} }} }}
plane {{ x, -2.4 pigment {{ {self.color()} }} }} plane {{ -x, -2.4 pigment {{ {self.color()} }} }}
"""
            return walls
        return f"sky_sphere {{ pigment {{ gradient y color_map {{ [0 {self.color(0.3)}] [1 {self.color(0.3)}] }} }} }}\nplane {{ y, 0 pigment {{ {self.color(0.3)} }} }}"

    def object(self, number):
        shape = self.r.choice([f"sphere {{ {self.place()}, {self.f(0.25, 0.6)} ", f"box {{ -{self.f(0.2, 0.5)}, {self.f(0.2, 0.5)} rotate {self.f(0, 90)}*y translate {self.place()} ",
                               f"cylinder {{ 0, {self.f(0.4, 1)}*y, {self.f(0.2, 0.4)} translate {self.place()} ",
                               f"torus {{ {self.f(0.3, 0.5)}, {self.f(0.08, 0.15)} rotate {self.f(0, 90)}*x translate {self.place()} "])
        if self.kind != "radiosity" and number < 2:
            if self.r.random() < 0.7:
                return shape + f"pigment {{ rgbf <{self.f(0.8, 1)}, {self.f(0.8, 1)}, {self.f(0.8, 1)}, 0.95> }} interior {{ ior {self.f(1.2, 1.8)} }} photons {{ target refraction on reflection on }} }}"
            return shape + f"pigment {{ {self.color(0.6)} }} finish {{ diffuse 0.1 reflection {self.f(0.5, 0.9)} metallic }} photons {{ target reflection on }} }}"
        extra = self.r.choice(["", "", "", f"finish {{ emission {self.f(0.3, 1)} }}" if self.kind != "photons" else "", "normal { bumps 0.4 scale 0.1 }", "finish { reflection 0.3 }"])
        return shape + f"pigment {{ {self.color()} }} {extra} }}"

    def text(self):
        objects = "\n".join(self.object(number) for number in range(self.r.randint(3, 6)))
        return f"""#version 3.7;
global_settings {{ assumed_gamma 1 {self.settings()}}}
#default {{ finish {{ ambient 0 diffuse 0.8 }} }}
camera {{ location <0, 1.6, -3.8> look_at <0, 1.1, 0> angle 70 }}
{self.light()}
{self.surroundings()}
{objects}
"""


def linear(path):
    """The linear light of a picture of 16 bits."""
    encoded = numpy.asarray(Image.open(path).convert("RGB"), dtype=float) / 255
    return numpy.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def blurred(picture, sigma=3.0):
    """The picture after a Gaussian blur; its edges are repeated."""
    n = int(3 * sigma)
    weights = numpy.exp(-0.5 * (numpy.arange(-n, n + 1) / sigma) ** 2)
    weights /= weights.sum()
    for axis in (0, 1):
        pad = [(n, n) if i == axis else (0, 0) for i in range(3)]
        wide = numpy.pad(picture, pad, mode="edge")
        picture = sum(w * numpy.take(wide, range(i, i + picture.shape[axis]), axis) for i, w in enumerate(weights))
    return picture


def compare(durer, seed, keep):
    """The scene's kind, and the relative differences of mean and blurred pictures; or the kind and a message."""
    scene = Scenes(seed)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(keep or folder)
        file = folder / f"{seed}.pov"
        file.write_text(scene.text())
        options = [f"+I{file.name}", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "+A0.3", "+WT1", "-GA"]
        for program, name in ((["povray", "-D"], "povray"), ([durer], "durer")):
            picture = folder / f"{seed}.{name}.png"
            done = subprocess.run([*program, *options, f"+O{picture.name}"], cwd=folder, capture_output=True, text=True, timeout=600)
            if not picture.exists():
                return scene.kind, f"{name}: {done.stderr[-300:]}"
        ours, theirs = (linear(folder / f"{seed}.{name}.png") for name in ("durer", "povray"))
    mean = max(theirs.mean(), 1e-3)
    return scene.kind, [abs(ours.mean() - mean) / mean, float(numpy.sqrt(((blurred(ours) - blurred(theirs)) ** 2).mean())) / mean]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True, type=os.path.abspath)
    parser.add_argument("--seed", type=int, default=1525)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--keep")
    options = parser.parse_args()
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    seeds = [options.seed * 1000003 + i for i in range(options.count)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        rows = list(pool.map(lambda seed: (seed, *compare(options.durer, seed, options.keep)), seeds))
    refused = [row for row in rows if isinstance(row[2], str)]
    drawn = [row for row in rows if not isinstance(row[2], str)]
    apart = [row for row in drawn if any(value > limit for value, limit in zip(row[2], LIMITS))]
    for seed, kind, said in refused:
        print(f"  refused  {seed} {kind}: {said}")
    for seed, kind, (mean, blur) in sorted(apart, key=lambda row: -row[2][1]):
        print(f"  differs  {seed} {kind}: mean {mean:.2%}, blurred {blur:.2%}")
    middle = [sorted(row[2][i] for row in drawn)[len(drawn) // 2] for i in range(2)]
    print(f"{len(drawn) - len(apart)} of {len(rows)} scenes alike; median difference of the mean {middle[0]:.2%}, of the blurred pictures {middle[1]:.2%}")
    sys.exit(1 if refused or len(apart) * 10 > len(rows) else 0)


if __name__ == "__main__":
    main()
