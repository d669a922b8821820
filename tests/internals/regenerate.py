#!/usr/bin/env python3
"""Asks the real POV-Ray for the functions of functions.inc at random points with random parameters.

    regenerate.py [SEED [POINTS]]    writes values.txt beside it, with which tests/suite/function_internals.rs compares
    regenerate.py --check            compares with values.txt instead; exit code 1 if it differs

Each line of values.txt: the function's name, x, y, z, its parameters, and what POV-Ray prints. Needs `povray` 3.7.

POV-Ray's f_hetero_mf and f_ridged_mf remember powers from one call to the next and go wrong when the parameters change, so each
of their calls has a run of its own.
"""

import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ALONE = ("f_hetero_mf", "f_ridged_mf")

# How many parameters each has.
COUNTS = """
algbr_cyl1 5 algbr_cyl2 5 algbr_cyl3 5 algbr_cyl4 5 bicorn 2 bifolia 2 blob 5 blob2 4 boy_surface 2 comma 1 cross_ellipsoids 4
crossed_trough 1 cubic_saddle 1 cushion 1 devils_curve 1 devils_curve_2d 6 dupin_cyclid 6 ellipsoid 3 enneper 1 flange_cover 4
folium_surface 3 folium_surface_2d 6 glob 1 heart 1 helical_torus 10 helix1 7 helix2 7 hex_x 1 hex_y 1 hetero_mf 6
hunt_surface 1 hyperbolic_torus 3 isect_ellipsoids 4 kampyle_of_eudoxus 3 kampyle_of_eudoxus_2d 6 klein_bottle 1
kummer_surface_v1 1 kummer_surface_v2 4 lemniscate_of_gerono 1 lemniscate_of_gerono_2d 6 mesh1 5 mitre 1 nodal_cubic 1 odd 1
ovals_of_cassini 4 paraboloid 1 parabolic_torus 3 ph 0 pillow 1 piriform 1 piriform_2d 7 poly4 5 polytubes 6 quantum 1
quartic_paraboloid 1 quartic_saddle 1 quartic_cylinder 3 r 0 ridge 6 ridged_mf 6 rounded_box 4 sphere 1 spikes 5 spikes_2d 4
spiral 6 steiners_roman 1 strophoid 4 strophoid_2d 7 superellipsoid 2 th 0 torus 2 torus2 3 torus_gumdrop 1 umbrella 1
witch_of_agnesi 2 witch_of_agnesi_2d 6 noise3d 0 noise_generator 1
""".split()
FUNCTIONS = {"f_" + name: int(count) for name, count in zip(COUNTS[::2], COUNTS[1::2])}


def special(name, index):
    """A parameter whose range matters, or None."""
    uniform = random.uniform
    fractal = [uniform(0, 1.5), uniform(1.5, 3), random.choice([uniform(1, 5), random.randint(1, 6)]), uniform(0, 1.5)]
    ranges = {
        "f_boy_surface": [uniform(-0.01, 0.01)],
        "f_hunt_surface": [uniform(-0.002, 0.002)],
        "f_heart": [uniform(-0.02, 0.02)],
        "f_klein_bottle": [uniform(-0.02, 0.02)],
        "f_torus_gumdrop": [uniform(-0.02, 0.02)],
        "f_hetero_mf": fractal + [random.choice([0, uniform(0, 1), uniform(1, 4)]), random.randint(0, 3)],
        "f_ridged_mf": fractal + [uniform(0, 3), random.randint(0, 3)],
        "f_ridge": [uniform(1.5, 3), fractal[2], uniform(0, 1), uniform(-1, 2), uniform(0, 2), random.randint(0, 3)],
        "f_mesh1": [uniform(0.3, 2), uniform(0.3, 2)],
        "f_polytubes": [uniform(-1, 7)],
        "f_helix1": [random.choice([1, 2, 3, uniform(0.5, 4)])],
        "f_noise_generator": [random.randint(-1, 4)],
    }
    row = ranges.get(name, [])
    return row[index] if index < len(row) else None


def arguments(name, sample):
    size = (0.5, 1.2, 3)[sample % 3]
    out = [round(random.uniform(-size, size), 4) for _ in range(3)]
    for index in range(FUNCTIONS[name]):
        value = special(name, index)
        usual = random.uniform(0, 2) if sample % 2 else random.uniform(-2, 2)
        out.append(round(usual if value is None else value, 4))
    return out


def povray(calls):
    """What POV-Ray prints for each (name, arguments)."""
    lines = ["#version 3.7;", '#include "functions.inc"', "global_settings { assumed_gamma 1 }"]
    for name, numbers in calls:
        call = "%s(%s)" % (name, ", ".join(map(repr, numbers)))
        lines.append('#debug concat("@", str(%s, 0, 15), "\\n")' % call)
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "q.pov").write_text("\n".join(lines))
        command = "povray +Iq.pov +W1 +H1 -D -GA +GDd.txt -F +WT1".split()
        subprocess.run(command, cwd=folder, capture_output=True, check=True)
        printed = pathlib.Path(folder, "d.txt").read_text()
    return [line.split("@")[1].strip() for line in printed.splitlines() if "@" in line]


def main():
    check = "--check" in sys.argv
    given = [word for word in sys.argv[1:] if word != "--check"]
    random.seed(int(given[0]) if given else 1)
    points = int(given[1]) if len(given) > 1 else 12
    calls = [(name, arguments(name, i)) for name in FUNCTIONS for i in range(points)]
    together = [call for call in calls if call[0] not in ALONE]
    answers = dict(zip(map(repr, together), povray(together)))
    for call in calls:
        if repr(call) not in answers:
            answers[repr(call)] = povray([call])[0]
    rows = ["%s %s %s" % (name, " ".join(map(repr, numbers)), answers[repr((name, numbers))]) for name, numbers in calls]
    text, file = "\n".join(rows) + "\n", HERE / "values.txt"
    if check:
        differences = sum(a != b for a, b in zip(text.splitlines(), file.read_text().splitlines()))
        print("%d values, %d differences" % (len(rows), differences))
        sys.exit(text != file.read_text())
    file.write_text(text)


main()
