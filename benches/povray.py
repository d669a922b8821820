#!/usr/bin/env python3
"""CPU time of durer and of POV-Ray over scenes, both in one run, by turns, one thread each.

    povray.py --durer D --tool ../shared/conformance/conformance.py [--only 'objects/*'] [--aa] [--size 320x240] [--rounds 2]

Takes the scenes of conformance.py that the ledger (tests/conformance.json) calls same or close, in a copy of their folder; of
several rounds the least time counts. Prints each scene, then the sums and what is slower than POV-Ray. With `--aa`
each smooths edges at the threshold 0.3, POV-Ray by its method 1, durer by `net`, its default, or as `--extra` says. For
trustworthy ratios let nothing else run.
"""
import argparse, fnmatch, json, math, os, pathlib, re, resource, shutil, subprocess, tempfile

HERE = pathlib.Path(__file__).resolve().parent


def seconds(command, folder, limit):
    """User and system time of a command, in seconds; infinite if it fails or takes longer than `limit` seconds."""
    child = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_utime + usage.ru_stime if child.returncode == 0 else math.inf


def least(pair, folder, options):
    """The least time of each of two commands, by turns; what is slower than POV-Ray gets more rounds."""
    best = [math.inf, math.inf]
    for done in range(options.rounds + options.again):
        if done >= options.rounds and (best[0] <= best[1] or math.inf in best):
            break
        best = [min(t, seconds(command, folder, options.limit)) for t, command in zip(best, pair)]
    return best


def commands(scene, folder, options, out):
    """The command lines that draw a scene with durer and with POV-Ray."""
    source = folder / scene["input"]
    width, height = options.size.split("x")
    durer = [options.durer, "render", source.name, "-I", options.includes, "-o", f"{out}/durer.png", "--size", options.size,
             "--threads", "1", "--progress", "never"] + scene.get("args", [])
    durer += ["--aa", "0.3"] + options.extra.split() if options.aa else ["--aa", "off"]
    povray = ["povray", source.name if source.suffix == ".ini" else f"+I{source.name}"]
    if scene.get("args"):
        frame = scene["args"][1]
        povray += [f"+SF{frame}", f"+EF{frame}"]
        if not re.search(r"(?im)^\s*input_file_name\s*=", source.read_text(errors="replace")):
            povray.append(f"+I{pathlib.Path(scene['name']).name.split('@')[0]}.pov")
    povray += [f"+O{out}/povray.png", f"+W{width}", f"+H{height}", "-D", "-P", "-V", "+WT1", "+FN8", "-GA"]
    povray += ["+A0.3", "+AM1", "+R3"] if options.aa else ["-A"]
    return durer, povray


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True)
    parser.add_argument("--tool", required=True, type=pathlib.Path)
    parser.add_argument("--only", action="append", default=[], help="glob over scene names; may repeat")
    parser.add_argument("--aa", action="store_true")
    parser.add_argument("--extra", default="", help="more arguments for durer with --aa, one string")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--again", type=int, default=3, help="more rounds for what was slower than POV-Ray")
    parser.add_argument("--limit", type=int, default=300, help="seconds for one picture")
    parser.add_argument("--corpus", default="/usr/share/doc/povray/examples")
    parser.add_argument("--includes", default="/usr/share/povray-3.7/include")
    options = parser.parse_args()
    options.durer = str(pathlib.Path(shutil.which(options.durer) or options.durer).resolve())
    known = json.load(open(HERE.parent / "tests/conformance.json"))
    scenes = [s for s in json.load(open(options.tool.parent / "scenes.json"))
              if s["ref"] == "ok" and known.get(s["name"]) in ("same", "close")
              and (not options.only or any(fnmatch.fnmatch(s["name"], g) for g in options.only))]
    with tempfile.TemporaryDirectory() as out:
        folder = pathlib.Path(out) / "corpus"
        shutil.copytree(options.corpus, folder)
        rows = []
        for scene in scenes:
            ours, theirs = least(commands(scene, folder, options, out), (folder / scene["input"]).parent, options)
            if math.inf in (ours, theirs):
                print(f"{'durer' if ours == math.inf else 'POV-Ray'} failed: {scene['name']}", flush=True)
                continue
            rows.append((scene["name"], ours, theirs))
            print(f"{ours:8.2f} {theirs:8.2f} {ours / theirs:6.2f} {scene['name']}", flush=True)
    ours, theirs = sum(r[1] for r in rows), sum(r[2] for r in rows)
    print(f"\n{len(rows)} scenes: durer {ours:.1f} s, POV-Ray {theirs:.1f} s, {ours / theirs:.3f}")
    for name, a, b in sorted(rows, key=lambda r: -r[1] / r[2]):
        if a > b:
            print(f"slower: {a / b:.2f} ({a:.2f} : {b:.2f} s) {name}")


if __name__ == "__main__":
    main()
