#!/usr/bin/env python3
"""Proves of `durer fmt`, over POV-Ray's own scenes or other folders: no file is lost, twice is once, and each scene is the Scene that it
was. (That tokens and comments stay, tests/suite/format.rs proves.)

    tests/format/prove.py [--durer DURER] [--jobs N] [FOLDER…]

The folders are copied, the copies formatted. Of each scene that ends in `.pov` or `.scene`, what `durer render --dump scene` prints is
compared, apart from places in the text. A scene that takes too long, before or after, is counted as not compared.
"""

import argparse
import concurrent.futures
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

INSTALLED = ["/usr/share/povray-3.7"]
# Of one scene.
SECONDS = 30
# `"file:line:column"`, where the dump tells a place, and what the scene says of itself.
PLACE = re.compile(rb'"[^"\n]*:\d+:\d+"')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", default="durer")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("folders", nargs="*", default=INSTALLED)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="durer-fmt-") as root:
        faults = []
        for number, folder in enumerate(args.folders):
            faults += prove(args, pathlib.Path(folder), pathlib.Path(root) / str(number))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


def prove(args, folder, root):
    before, after = root / "before", root / "after"
    for copy in (before, after):
        shutil.copytree(folder, copy, copy_function=shutil.copyfile)
    texts = [path for ending in ("pov", "inc", "scene") for path in after.rglob(f"*.{ending}")]
    first = run([args.durer, "fmt", "."], after)
    if first.returncode not in (0, 1):
        return [f"fmt ends with exit code {first.returncode}:", first.stderr.decode(errors="replace")]
    again = run([args.durer, "fmt", "--check", "."], after)
    faults = [f"{line}: twice is not once" for line in again.stderr.decode(errors="replace").splitlines() if is_text(line)]
    scenes = sorted(path.relative_to(after) for path in texts if path.suffix != ".inc")
    changed = sum((before / path.relative_to(after)).read_bytes() != path.read_bytes() for path in texts)
    left = first.stderr.decode(errors="replace").count("is unchanged")
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        compared = list(pool.map(lambda scene: compare(args, before, after, scene), scenes))
    faults += [f"{scene}: not the same Scene" for scene, same in zip(scenes, compared) if same is False]
    print(f"{folder}: {len(texts)} texts, {changed} changed, {left} left as they are; "
          f"{compared.count(True)} of {len(scenes)} Scenes are the same, {compared.count(None)} not compared")
    return faults


def is_text(line):
    return line.endswith((".pov", ".inc", ".scene"))


def compare(args, before, after, scene):
    """Are both the same Scene? None if that is not known."""
    try:
        a, b = (dump(args, root, scene) for root in (before, after))
    except subprocess.TimeoutExpired:
        return None
    return a == b


def dump(args, root, scene):
    """The Scene without places; what is printed on the way and the kinds of messages belong to it."""
    done = run([args.durer, "render", "--dump", "scene", "--max-steps", "20000000", "-I", str(root / "include"), scene.name],
               root / scene.parent, SECONDS)
    codes = re.findall(rb"\b[EW]\d{4}\b", done.stderr)
    # How lines are broken depends on how long places are. Large ones are not kept.
    text = done.stdout.replace(str(root).encode(), b"")
    scene = PLACE.sub(b"", text).translate(None, b" \n")
    return hashlib.sha256(scene).digest(), sorted(codes), done.returncode


def run(command, folder, seconds=None):
    return subprocess.run(command, cwd=folder, capture_output=True, timeout=seconds)


main()
