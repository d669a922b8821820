#!/usr/bin/env python3
"""Draws random scenes with POV-Ray and durer, and fails when fewer are the same than `ledger.json` says.

    check.py --durer PATH [--tool ../shared/random/random_scenes.py] [--update]

Each row of the ledger is a run of the tool with fixed seeds: of its own generator, or of `scenes.py` beside this file. `--update` keeps
what this run found, if it is better. What differs still, and why, stands in README.md.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
LEDGER = HERE / "ledger.json"
TOOL = HERE.parent.parent.parent / "shared" / "random" / "random_scenes.py"


def run(tool, durer, row):
    """How many scenes POV-Ray drew, and how many of them durer draws the same."""
    words = [sys.executable, tool, "--durer", durer, "--count", str(row["count"]), "--seed", str(row["seed"]), "--jobs", "8"]
    if "generator" in row:
        words += ["--generator", HERE / row["generator"]]
    # (Its exit code tells whether any scene differs at all.)
    out = subprocess.run(words, capture_output=True, text=True)
    found = re.search(r"^(\d+) scenes that POV-Ray draws: (\d+) same.*", out.stdout, re.MULTILINE)
    if not found:
        raise SystemExit(f"{out.stdout}{out.stderr}\nthe tool ended with {out.returncode}")
    worst = [line for line in out.stdout.splitlines() if line.startswith(("refused", "differs"))]
    print(f"{row.get('generator', 'the given generator')}: {found[0]}", *worst[:5], sep="\n  ")
    return {"drawn": int(found[1]), "same": int(found[2]), "refused": sum(line.startswith("refused") for line in worst)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True)
    parser.add_argument("--tool", default=TOOL)
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    rows, fails = json.loads(LEDGER.read_text()), 0
    for row in rows:
        found = run(options.tool, options.durer, row)
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
