#!/usr/bin/env python3
"""Table of radiosity's FLIP errors against POV-Ray's picture with converged radiosity, for scenes of POV-Ray's distribution.

    against_converged.py DURER SCENE… [--corpus DIR] [--out DIR] [--count N] [--error-bound E] [--more TEXT]

SCENE is a name in `../shared/conformance/scenes.json` without `.pov`, such as `animations/raddem/raddem@30`. Both programs render the scene
and a variant, whose `radiosity` blocks end with the settings CONVERGED. The variant keeps `recursion_limit`, `brightness` and the other
settings of the scene. Columns of the table, each a mean FLIP error of two pictures:

    POV-Ray    POV-Ray's picture of the scene, against POV-Ray's picture of the variant
    durer      durer's picture of the scene, against POV-Ray's picture of the variant
    variant    durer's picture of the variant, against POV-Ray's picture of the variant
    scene      durer's picture of the scene, against POV-Ray's picture of the scene

`--error-bound` has to be no greater than the scene's own, or the variant interpolates over longer distances than the scene does.
The last two columns are the mean sRGB colours of the variant's pictures, POV-Ray's first, from 0 to 255. `--out` keeps the pictures.
Needs `povray` on the path, and the Python packages `numpy`, `pillow` and `flip-evaluator`.
"""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import flip_evaluator
import numpy
from PIL import Image

CASES = pathlib.Path(__file__).resolve().parents[3] / "shared" / "conformance" / "scenes.json"
INCLUDES = "/usr/share/povray-3.7/include"
SIZE = (160, 120)
CONVERGED = "count {count} nearest_count 10 error_bound {error_bound} low_error_factor 0.7 pretrace_end 0.01"
BLOCK = re.compile(r"(\bradiosity\s*\{[^{}]*)\}")


def povray_command(case, picture):
    """Command line as in `make_refs.py`: an `.ini` names its scene itself, and a frame is a range of one."""
    scene = pathlib.Path(case["input"]).name
    frames = [f"+SF{case['args'][1]}", f"+EF{case['args'][1]}"] if case["args"] else []
    size = [f"+W{SIZE[0]}", f"+H{SIZE[1]}"]
    return ["povray", scene if scene.endswith(".ini") else f"+I{scene}", *frames, f"+O{picture}", *size] + (
        f"-A -D -P +WT1 +FN8 -GA +L{INCLUDES}".split()
    )


def durer_command(durer, case, picture):
    """Command line as in `conformance.py`."""
    size = f"{SIZE[0]}x{SIZE[1]}"
    options = f"--size {size} --aa off --threads 1 --progress never".split()
    return [durer, "render", pathlib.Path(case["input"]).name, "-I", INCLUDES, "-o", picture, *options, *case["args"]]


def rendered(command, folder, made, seconds):
    """Runs `command` in `folder`, and returns the picture that appears in the empty folder `made`, with its time in seconds."""
    start = time.time()
    subprocess.run(command, cwd=folder, check=True, timeout=seconds, stdin=subprocess.DEVNULL, capture_output=True)
    (picture,) = made.glob("*.png")
    return picture, time.time() - start


def converge(folder, settings):
    """Appends `settings` to each `radiosity` block of the scenes and included files in `folder`."""
    for path in [*folder.glob("*.pov"), *folder.glob("*.inc")]:
        text = path.read_text(encoding="latin-1")
        changed = BLOCK.sub(lambda block: f"{block[1]}\n{settings}\n}}", text)
        if changed != text:
            path.write_text(changed, encoding="latin-1")


def pictures(durer, case, corpus, out, settings, seconds):
    """Four pictures `{(program, kind): path}` of a scene and its variant, and the seconds of each."""
    original = (corpus / case["input"]).parent
    key, paths, times = case["name"].removesuffix(".pov").replace("/", "__"), {}, {}
    # Scenes write files beside themselves: render in a copy of their folder, beside it because of relative paths.
    with tempfile.TemporaryDirectory(dir=original.parent, prefix="converged-") as temporary:
        folder = pathlib.Path(temporary) / original.name
        for kind in ("scene", "variant"):
            shutil.copytree(original, folder)
            if kind == "variant":
                converge(folder, settings)
            for program in ("povray", "durer"):
                made = pathlib.Path(temporary) / f"{kind}-{program}"
                made.mkdir()
                picture = made / "out.png"
                command = povray_command(case, picture) if program == "povray" else durer_command(durer, case, picture)
                picture, times[program, kind] = rendered(command, folder, made, seconds)
                paths[program, kind] = shutil.copy(picture, out / f"{key}-{kind}-{program}.png")
            shutil.rmtree(folder)
    return paths, times


def flip_error(reference, test):
    """Mean LDR-FLIP error of two pictures, as in `conformance.py`."""
    return float(flip_evaluator.evaluate(reference, test, "LDR", applyMagma=False)[1])


def row(name, paths):
    """One line of the table."""
    images = {key: numpy.asarray(Image.open(path).convert("RGB"), dtype=numpy.float32) / 255 for key, path in paths.items()}
    theirs, converged = images["povray", "scene"], images["povray", "variant"]
    ours, ours_converged = images["durer", "scene"], images["durer", "variant"]
    pairs = [(converged, theirs), (converged, ours), (converged, ours_converged), (theirs, ours)]
    errors = "".join(f"{flip_error(*pair):9.4f}" for pair in pairs)
    colors = (" ".join(f"{255 * value:5.1f}" for value in image.mean(axis=(0, 1))) for image in (converged, ours_converged))
    return f"{name:44}{errors}   " + "   ".join(colors)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("durer", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("scenes", nargs="+", metavar="SCENE")
    parser.add_argument("--corpus", type=pathlib.Path, default=pathlib.Path("/tmp/exa"), help="writable copy of the distribution")
    parser.add_argument("--cases", type=pathlib.Path, default=CASES, help="scenes.json of the conformance tool")
    parser.add_argument("--out", type=pathlib.Path, help="folder for the pictures")
    parser.add_argument("--count", type=int, default=1200)
    parser.add_argument("--error-bound", type=float, default=0.3)
    parser.add_argument("--more", default="", help="more settings of the variant, such as 'maximum_reuse 0.02'")
    parser.add_argument("--seconds", type=float, default=240, help="limit for one picture")
    options = parser.parse_args()
    cases = {case["name"].removesuffix(".pov"): case for case in json.loads(options.cases.read_text())}
    settings = CONVERGED.format(count=options.count, error_bound=options.error_bound) + f" {options.more}"
    print(f"{'':44}{'POV-Ray':>9}{'durer':>9}{'variant':>9}{'scene':>9}   mean colours")
    with tempfile.TemporaryDirectory() as temporary:
        out = options.out or pathlib.Path(temporary)
        out.mkdir(parents=True, exist_ok=True)
        for name in options.scenes:
            try:
                paths, times = pictures(options.durer, cases[name], options.corpus, out, settings, options.seconds)
            except subprocess.TimeoutExpired as problem:
                print(f"{name:44}{problem.cmd[0]} takes more than {options.seconds:g} s", flush=True)
                continue
            print(row(name, paths), flush=True)
            print(name, {"-".join(key): round(value, 1) for key, value in times.items()}, file=sys.stderr)


if __name__ == "__main__":
    main()
