#!/usr/bin/env python3
"""Counts the instructions that durer needs for small scenes, and fails where one needs more than `instructions.json` says.

    instructions.py --durer D [--update] [--allowed 0.03] [SCENE...]

Each scene of `instructions/` is drawn at 120x90 pixels with anti-aliasing by one thread under Valgrind, whose count hardly differs from
run to run, unlike a time. `--update` stores the counts of this run. A count depends on the compiler and a little on the processor: the
ledger is written anew after a change of the compiler. Needs `valgrind`.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LEDGER = HERE / "instructions.json"
SIZE = (120, 90)


def instructions(durer, scene):
    """The number of instructions of one render, in millions."""
    with tempfile.TemporaryDirectory() as folder:
        # (Without a journal, whose beginning depends on time.)
        options = ["--size", f"{SIZE[0]}x{SIZE[1]}", "--aa", "0.3", "--threads", "1", "--keep-after", "1e9"]
        draw = [durer, "render", str(scene), "--output", f"{folder}/out.png", *options]
        count = ["valgrind", "--tool=cachegrind", "--cache-sim=no", f"--cachegrind-out-file={folder}/counts", *draw]
        done = subprocess.run(count, cwd=scene.parent, capture_output=True, text=True)
        found = re.search(r"I\s+refs:\s+([\d,]+)", done.stderr)
        if done.returncode != 0 or not found:
            raise SystemExit(f"{scene.stem}: {done.stderr[-2000:]}")
    return round(int(found[1].replace(",", "")) / 1e6, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--allowed", type=float, default=0.03, help="share by which a count may be larger than the ledger's")
    parser.add_argument("scenes", nargs="*")
    options = parser.parse_args()
    durer = str(pathlib.Path(options.durer).resolve())
    ledger = json.loads(LEDGER.read_text()) if LEDGER.exists() else {}
    scenes = [path for path in sorted((HERE / "instructions").glob("*.pov")) if not options.scenes or path.stem in options.scenes]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = dict(zip((path.stem for path in scenes), pool.map(lambda path: instructions(durer, path), scenes)))
    more = []
    for name, count in counts.items():
        before = ledger.get(name)
        share = f"{count / before:.3f} of the ledger's" if before else "not in the ledger"
        print(f"{count:9.1f} million  {name:14} {share}")
        if before is None or count > before * (1 + options.allowed):
            more.append(name)
    if options.update:
        LEDGER.write_text(json.dumps({**ledger, **counts}, indent=4, sort_keys=True) + "\n")
    elif more:
        print("more instructions than the ledger says: " + ", ".join(more))
        return 1
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
