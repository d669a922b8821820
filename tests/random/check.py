#!/usr/bin/env python3
"""Draws random scenes with POV-Ray and durer, and fails when fewer are the same than `ledger.json` says.

    check.py --durer PATH [--tool ../shared/random/random_scenes.py] [--update] [--why]

Each row of the ledger is a run of the tool with fixed seeds: of its own generator, or of `scenes.py` beside this file. `--update` keeps
what this run found, if it is better. What differs still, and why, stands in README.md; `--why` names each scene that is not the same,
and tells where POV-Ray's picture depends on the order of its pixels: those drawn alone are as durer's.
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


def run(tool, durer, row, why):
    """How many scenes POV-Ray drew, and how many of them durer draws the same."""
    jobs = [(row["seed"] * 1000003 + i, durer, None, None) for i in range(row["count"])]
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        rows = [r for r in pool.map(tool.one, jobs) if r[1] and r[1] != "unstable"]
    others = sorted((r for r in rows if r[1] != "same"), key=lambda r: -r[2])
    found = {"drawn": len(rows), "same": len(rows) - len(others), "refused": sum(r[1] == "refused" for r in others)}
    print(f"{row.get('generator', 'the given generator')}, seed {row['seed']}: {found['same']} of {found['drawn']} are the same")
    by_order = 0
    for seed, verdict, share, said in others if why else others[:5]:
        if why and order_matters(tool, durer, seed):
            by_order += 1
            said = "by the order of POV-Ray's pixels"
        print(f"  {verdict:8} {share:7.2%} {seed}  {said[:120]}")
    if why:
        print(f"  {by_order} of {len(others)} by the order of POV-Ray's pixels")
    return found


def order_matters(tool, durer, seed):
    """Does POV-Ray draw a pixel that differs as durer does, when it is drawn alone?"""
    text, judge = tool.GENERATOR(seed, tool.families_of(seed, None)).text(), Judge(durer, tool, 0)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        ours, theirs = judge.ours(text, folder), judge.povray(text, folder)
        return ours is not None and theirs is not None and judge.by_order(text, folder, theirs, ours)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True)
    parser.add_argument("--tool", default=TOOL)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--why", action="store_true")
    options = parser.parse_args()
    rows, fails = json.loads(LEDGER.read_text()), 0
    for row in rows:
        tool = use(options.tool, row.get("generator", "given"))
        found = run(tool, str(pathlib.Path(options.durer).resolve()), row, options.why)
        # (POV-Ray crashes at times when it ends, and draws one scene less.)
        others, before = found["drawn"] - found["same"], row["drawn"] - row["same"]
        if others > before or found["drawn"] < 0.95 * row["drawn"] or found["refused"]:
            print(f"  fewer than the ledger says: {row['same']} of {row['drawn']} were the same")
            fails += 1
        elif options.update:
            row.update(drawn=found["drawn"], same=found["same"])
    if options.update:
        LEDGER.write_text("[\n" + ",\n".join("    " + json.dumps(row) for row in rows) + "\n]\n")
    return 1 if fails else 0


if __name__ == "__main__":
    raise SystemExit(main())
