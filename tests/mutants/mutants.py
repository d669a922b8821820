#!/usr/bin/env python3
"""Runs mutated scenes, INI files and command lines through all commands of durer.

Each run must end with an exit code from 0 to 5, without a panic, within its time limit and half a second, and within
its memory limit and a tenth, plus 64 MB. The mutants of one seed are always the same.

    mutants.py --durer target/debug/durer --count 1000 --seed 1 [--jobs 2] [--keep FOLDER]

A build with overflow checks, such as that of `cargo build`, finds most. Failures are printed, and with `--keep` their
files are kept in FOLDER. The exit code is 1 after a failure.
"""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
POVRAY_SCENES = pathlib.Path("/usr/share/povray-3.7/scenes")
MAX_TIME, MAX_MEMORY = 4.0, 512 << 20
NUMBERS = """0 -0 1 -1 2 -2 0.5 1e-7 -1e-7 1e-300 5e-324 1e7 -1e7 1e18 -1e18 1e300 -1e300 1e308 1e999 2147483647
    2147483648 -2147483649 4294967296 9223372036854775807 9223372036854775808 -9223372036854775809 65535 65536 256 255
    1000000 100000 1/3 pi""".split()
TOKEN = re.compile(r'"[^"\n]*"|//[^\n]*|\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+|\w+|\s+|.', re.S)
OPTIONS = """+A0.1 +AM2 +AM3 +R3 +Q11 +Q0 +UA +FN16 +FT +FC +FJ +FP +FE +FH +FB -F +KFI1 +KFF3 +SC0.2 +EC9 +SR3 +ER0.9 +GI
    +RF +MV3.1 +MV1 +L/ +HIx +D0 -J +TH +FG2.2 +WT1 --alpha --gray --no-output --frames=1-3 --region=1,1,4,4 --aa=off
    --aa-method=corners --quality=11 --file-gamma=1.0 --dither=fs --declare=A=1 Declare=B=<1,2> Width=9 Height=1e9
    Antialias=on Output_File_Type=t Clock=nan --clock=0..1 --frame=2 --language=3.5 --threads=3""".split()


def corpus():
    """Paths of the scenes that are mutated."""
    folders = [ROOT / "scenes", ROOT / "tests/lang", ROOT / "tests/ui", ROOT / "tests/light_cases"]
    if POVRAY_SCENES.is_dir():
        folders.append(POVRAY_SCENES)
    paths = [p for folder in folders for p in sorted(folder.rglob("*")) if p.suffix in (".scene", ".pov")]
    return [p for p in paths if p.stat().st_size < 60_000]


def read(path):
    return path.read_text(encoding="latin-1")


class Mutator:
    def __init__(self, rng, paths, words):
        self.rng, self.paths, self.words = rng, paths, words

    def mutate(self, text):
        """Returns the text after one to five changes of its tokens."""
        tokens = TOKEN.findall(text)
        for _ in range(self.rng.choice([1, 1, 1, 2, 2, 3, 5])):
            if tokens:
                self.change(tokens)
        return "".join(tokens)

    def change(self, tokens):
        rng = self.rng
        places = range(len(tokens))
        numbers = [i for i in places if tokens[i][0].isdigit() or tokens[i][0] == "."]
        names = [i for i in places if tokens[i][0].isalpha()]
        kind = rng.random()
        if kind < 0.45 and numbers:
            tokens[rng.choice(numbers)] = " " + rng.choice(NUMBERS) + " "
        elif kind < 0.6 and names:
            tokens[rng.choice(names)] = rng.choice(self.words)
        elif kind < 0.7:
            del tokens[rng.choice(places)]
        elif kind < 0.78:
            at, end = sorted(rng.choice(places) for _ in "ab")
            tokens[at:at] = tokens[at : min(end, at + 60)] * rng.choice([1, 1, 2, 30])
        elif kind < 0.84:
            at, other = rng.choice(places), rng.choice(places)
            tokens[at], tokens[other] = tokens[other], tokens[at]
        elif kind < 0.92:
            other = TOKEN.findall(read(rng.choice(self.paths)))
            at = rng.randrange(max(1, len(other)))
            place = rng.choice(places)
            tokens[place:place] = other[at : at + rng.randrange(1, 80)]
        elif kind < 0.96:
            at = rng.choice(places)
            del tokens[at : at + rng.randrange(1, 40)]
        else:
            tokens.insert(rng.choice(places), rng.choice(["\0", "\xff", "{" * 300, "(" * 300, "}", "#end ", "#if(1) ", '"', "/*"]))


def command(rng):
    """Returns the words of a random command for `m.pov`."""
    size = rng.choice(["12x9", "12x9", "1x1", "7x16", "40x2"])
    look = rng.choice([[], ["--aa", "off"], ["--aa", "0", "--aa-depth", "2"], ["--alpha"], ["--quality", "11"], ["--aa-method", "corners"]])
    limited = ["--max-time", str(MAX_TIME), "--max-memory", str(MAX_MEMORY), "-I", "."]
    untrusted = rng.choice([[], [], ["--untrusted"]])
    kind = rng.random()
    if kind < 0.55:
        ending = rng.choice(["png", "png", "png", "jpg", "tga", "exr", "hdr", "bmp", "ppm", "tiff"])
        output = ["-o", f"out.{ending}"] if ending in ("png", "exr", "tga", "tiff") or "--alpha" not in look else ["-o", "out.png"]
        return ["render", "m.pov", "--size", size, *look, *output, *limited, *untrusted]
    if kind < 0.65:
        return ["check", "m.pov", "--format", rng.choice(["human", "json"]), "--warn", "portable,unused", *limited, *untrusted]
    if kind < 0.72:
        return ["pick", "m.pov", f"{rng.randrange(12)},{rng.randrange(9)}", "--size", "12x9", *rng.choice([[], ["--json"]]), *limited]
    if kind < 0.79:
        return ["query", "m.pov", *rng.choice([[], ["--json"]]), *limited]
    if kind < 0.86:
        return ["render", "m.pov", "--dump", rng.choice(["scene", "world"]), "--size", size, *limited]
    if kind < 0.94:
        return ["fmt", *rng.choice([["--diff"], ["--check"], []]), "--width", rng.choice(["40", "100", "10000"]), "m.pov"]
    return ["+Im.pov", "+W12", "+H9", *rng.choices(OPTIONS, k=rng.randrange(5)), *limited[:4]]


def run(arguments):
    """Runs one mutant; returns the kind of its failure or None, a text about it, its command and its exit code."""
    durer, seed, paths, words, keep = arguments
    rng = random.Random(seed)
    source = rng.choice(paths)
    text = Mutator(rng, paths, words).mutate(read(source))
    folder = pathlib.Path(tempfile.mkdtemp(prefix=f"mutant-{seed}-"))
    try:
        (folder / "m.pov").write_text(text, encoding="latin-1")
        line = command(rng)
        if "+Im.pov" not in line and "fmt" not in line:
            line += ["-I", str(source.parent)]
        started = time.monotonic()
        process = subprocess.Popen([durer, *line], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=open(folder / "stderr", "wb"))
        usage, status = wait(process, MAX_TIME + 6)
        seconds = time.monotonic() - started
        errors = (folder / "stderr").read_text(errors="replace")
        failure = verdict(status, usage, seconds, errors)
        if failure and keep:
            kept = pathlib.Path(keep) / f"{seed}"
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(folder, kept)
            (kept / "command").write_text(" ".join(line) + f"\n# from {source}\n")
        note = next((l for l in errors.splitlines() if "panicked" in l), errors.splitlines()[-1] if errors else "")
        return failure, f"{failure} seed {seed} ({source.name}): {' '.join(line[:6])}: {note[:200]}", line[0], status
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def wait(process, limit):
    """Waits for a process, and ends it after `limit` seconds. Returns its resources and its status."""
    until = time.monotonic() + limit
    pause = 0.001
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return usage, process.returncode
        if time.monotonic() > until:
            process.kill()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            return usage, None
        time.sleep(pause)
        pause = min(pause * 1.5, 0.02)


def verdict(status, usage, seconds, errors):
    if "panicked at" in errors or "internal error" in errors:
        return "PANIC"
    if status is None:
        return "HANG"
    if not 0 <= status <= 5:
        return f"EXIT {status}"
    if usage.ru_maxrss * 1024 > MAX_MEMORY * 1.1 + (64 << 20):
        return f"MEMORY {usage.ru_maxrss >> 10} MB"
    # Other runs share the processor, so its own time counts, too.
    if seconds > MAX_TIME + 1.5 and usage.ru_utime + usage.ru_stime > MAX_TIME + 0.5:
        return f"LATE {seconds:.1f} s"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True, type=os.path.abspath)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep")
    options = parser.parse_args()
    paths = corpus()
    words = sorted({w for p in paths[::3] for w in re.findall(r"[A-Za-z_]{2,}", read(p))})
    jobs = [(options.durer, seed, paths, words, options.keep) for seed in range(options.seed, options.seed + options.count)]
    failures, commands, exits = [], collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for failure, text, name, status in pool.map(run, jobs):
            commands[name] += 1
            exits[status] += 1
            if failure:
                failures.append(text)
                print(text, flush=True)
    counts = lambda counter: ", ".join(f"{name} {n}" for name, n in counter.most_common())
    print(f"{options.count} mutants, {len(failures)} failures; commands: {counts(commands)}; exit codes: {counts(exits)}")
    raise SystemExit(bool(failures))


if __name__ == "__main__":
    main()
