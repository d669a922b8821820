#!/usr/bin/env python3
"""How far each method of anti-aliasing is from a picture of 81 rays a pixel, and how many rays it casts.

    smooth.py --durer D [--threshold 0.3] [--keep FOLDER]

The figures of docs/src/output.md, "Smooth edges": the mean square difference of the numbers of a picture (0 to 1, 16 bits), over five scenes.
Needs numpy.
"""
import argparse, json, pathlib, subprocess, tempfile
import numpy

MIRRORED = "camera { location <0, 2, -6> look_at 0 } light_source { <4, 8, -5>, 1 } plane { y, -1 pigment { checker rgb 1, rgb 0.1 } }\n"
SCENES = {
    "a mirror ball over checkers": MIRRORED + "sphere { 0, 1 pigment { rgb <0.3, 0.4, 0.9> } finish { reflection 0.5 } }",
    "thin rods": "camera { location <0, 0, -10> look_at 0 } light_source { <5, 8, -9>, 1 } background { rgb 0.8 } #declare R = seed(3);\n"
    "#for (I, 1, 150) cylinder { <rand(R), rand(R), rand(R)> * 8 - 4, <rand(R), rand(R), rand(R)> * 8 - 4, 0.03 pigment { rgb <rand(R), rand(R), 0.2> } } #end",
    "letters before bricks": "camera { location <0, 0.3, -6> look_at <0, 0.3, 0> } light_source { <-4, 6, -9>, 1 }\n"
    'plane { -z, -1 pigment { brick rgb 0.9, rgb <0.6, 0.2, 0.1> scale 0.1 } }\n'
    'text { internal 1 "durer draws" 0.3, 0 pigment { rgb <0.1, 0.3, 0.2> } translate <-2.6, 0.2, 0> }',
    "mirrors and glass": MIRRORED + "#for (I, 0, 8) sphere { <mod(I, 3) - 1, -0.6, div(I, 3) - 1> * <1.2, 1, 1.2>, 0.4\n"
    "#if (mod(I, 2)) pigment { rgbf <0.9, 1, 0.9, 0.9> } interior { ior 1.5 } #else pigment { rgb 0.2 } finish { reflection 0.8 } #end } #end",
    "granite before checkers": MIRRORED + "box { -1, 1 pigment { granite color_map { [0 rgb 0] [1 rgb 1] } } rotate y * 30 }",
}


def draw(options, folder, scene, name, arguments):
    """The numbers of a picture, and the rays of its pixels per pixel."""
    command = [options.durer, "render", scene, "-o", f"{folder}/{name}.ppm", "--bit-depth", "16", "--size", "320x240", "--progress", "never"]
    subprocess.run(command + ["--stats", f"{folder}/stats.json"] + arguments, check=True)
    data = (folder / f"{name}.ppm").read_bytes()
    numbers = numpy.frombuffer(data[-320 * 240 * 6:], ">u2").astype(float) / 65535
    return numbers, json.loads((folder / "stats.json").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True)
    parser.add_argument("--threshold", default="0.3")
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    methods = ["net", "grid", "corners"]
    sums = numpy.zeros((len(methods), 2))
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        for i, (name, text) in enumerate(SCENES.items()):
            scene = folder / f"{i}.pov"
            scene.write_text(f"#version 3.7; global_settings {{ assumed_gamma 1 }}\n{text}\n")
            want, _ = draw(options, folder, scene, f"{i}", ["--aa", "0", "--aa-method", "grid", "--aa-depth", "9"])
            found = []
            for method in methods:
                numbers, stats = draw(options, folder, scene, f"{i}-{method}", ["--aa", options.threshold, "--aa-method", method])
                found.append([((numbers - want) ** 2).mean(), stats["rays"]["camera"] / (320 * 240)])
            print(f"{name:28}" + "".join(f"   {method} {error:.6f} {rays:5.2f}" for method, (error, rays) in zip(methods, found)))
            sums += found
        print(f"{'mean':28}" + "".join(f"   {m} {error:.6f} {rays:5.2f}" for m, (error, rays) in zip(methods, sums / len(SCENES))))


main()
