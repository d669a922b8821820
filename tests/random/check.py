#!/usr/bin/env python3
"""Draws random scenes with POV-Ray and durer, and fails when more differ by themselves than `ledger.json` says.

    check.py --durer PATH [--tool ../shared/random/random_scenes.py] [--update] [--seed N --count N [--generator scenes.py]]

Each row of the ledger is a run of the tool with fixed seeds: of its own generator, or of `scenes.py` beside this file. (`--seed` asks for
another row, of which the ledger knows nothing.) Every scene is one of

- same: at most 0.2 % of the pixels differ;
- unstable: POV-Ray's picture depends on the order of its pixels: most of those that differ, drawn alone, are as durer's;
- by digits: POV-Ray's picture depends on the last digits of the camera: without the pixels that it draws otherwise when the camera moves
  by a billionth in one of eight ways, the scene is the same;
- other, which is named, and what this fails on. What differs still, and why, stands in README.md.

The second and third are shown each time by drawing. `--update` keeps what this run found, if it is better.
"""

import argparse
import concurrent.futures
import json
import pathlib
import tempfile

from shrink import Judge
from tool import TOOL, use

HERE = pathlib.Path(__file__).resolve().parent
LEDGER = HERE / "ledger.json"


CLASSES = ("same", "unstable", "by digits", "other")
# As the tool has it.
SAME = 0.002


def run(tool, durer, row):
    """How many scenes POV-Ray drew, and how many of them are of each class."""
    jobs = [(row["seed"] * 1000003 + i, durer, None, None) for i in range(row["count"])]
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        rows = [r for r in pool.map(tool.one, jobs) if r[1]]
        others = sorted((r for r in rows if r[1] != "same"), key=lambda r: -r[2])
        classes = list(pool.map(lambda r: "other" if r[1] == "refused" else r[1] if r[1] == "unstable" else class_of(tool, durer, r[0]), others))
    found = {"drawn": len(rows), **{name: classes.count(name) for name in CLASSES}}
    found["same"] += len(rows) - len(others)
    told = ", ".join(f"{found[name]} {name}" for name in CLASSES)
    judged = found["drawn"] - found["unstable"] - found["by digits"]
    print(f"{row.get('generator', 'the given generator')}, seed {row['seed']}: of {found['drawn']}, {told}; {found['same'] / judged:.2%} of those that POV-Ray knows itself")
    for (seed, verdict, share, said), name in zip(others, classes):
        if name == "other":
            print(f"  {verdict:8} {share:7.2%} {seed}  {said[:120]}")
    return found


def class_of(tool, durer, seed):
    """Why it differs: one of CLASSES."""
    import numpy

    text, judge = tool.GENERATOR(seed, tool.families_of(seed, None)).text(), Judge(durer, tool, 0)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        ours, theirs = judge.ours(text, folder), judge.povray(text, folder)
        if ours is None or theirs is None:
            return "other"
        if judge.by_order(text, folder, theirs, ours):
            return "unstable"
        differs = lambda a, b: abs(a - b).max(-1) > 2
        left = differs(ours, theirs)
        # (Of two pictures that the last digits make, chance makes half of the pixels alike.)
        for way in range(8):
            moved = judge.povray(judge.moved(text, way), folder)
            if moved is not None:
                left = left & ~differs(theirs, moved)
        return "by digits" if numpy.mean(left) <= SAME else "other"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True)
    parser.add_argument("--tool", default=TOOL)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--seed", type=int)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--generator", default="given")
    options = parser.parse_args()
    asked = {"generator": options.generator, "seed": options.seed, "count": options.count}
    rows, fails = json.loads(LEDGER.read_text()) if options.seed is None else [asked], 0
    for row in rows:
        tool = use(options.tool, row.get("generator", "given"))
        found = run(tool, str(pathlib.Path(options.durer).resolve()), row)
        if "drawn" not in row:
            continue
        # (POV-Ray crashes at times when it ends, and draws one scene less. An old row knows no classes.)
        before = row.get("other", row["drawn"] - row["same"])
        if found["other"] > before or found["drawn"] < 0.95 * row["drawn"]:
            print(f"  more than the ledger says: {before} differed by themselves")
            fails += 1
        elif options.update:
            row.update(found)
    if options.update:
        LEDGER.write_text("[\n" + ",\n".join("    " + json.dumps(row) for row in rows) + "\n]\n")
    return 1 if fails else 0


if __name__ == "__main__":
    raise SystemExit(main())
