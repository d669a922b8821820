#!/usr/bin/env python3
"""Measures what shards cost: CPU time of all shards of a picture and of their merging, against that of one process.

    cost.py --durer target/release/durer SCENE… [--counts 1,2,4,8,64,1024] [--size 1280x720]

Prints a row for each scene and number of shards, and for each scene the time until its first tile: text, data structures,
photons and radiosity, which each shard spends again.
"""
import argparse, json, os, pathlib, resource, subprocess, tempfile, time


def cpu_of(call, cwd):
    """CPU time of a command in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(call, check=True, cwd=cwd, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True)
    parser.add_argument("--counts", default="1,2,4,8,64,1024")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("scenes", nargs="+")
    options = parser.parse_args()
    durer = os.path.abspath(options.durer)
    print("| scene | start-up | shards | CPU of all, in that of one render | slowest shard, in the mean | merge |\n|---|---|---|---|---|---|")
    for scene in options.scenes:
        path = pathlib.Path(scene).resolve()
        with tempfile.TemporaryDirectory() as folder:
            line = [durer, "render", str(path), "--size", options.size, "-j1", "-q"]
            whole = cpu_of([*line, "-o", f"{folder}/whole.png", "--stats", f"{folder}/stats.json"], path.parent)
            stats = json.loads(pathlib.Path(folder, "stats.json").read_text())
            start = stats["times"]["parse"] + stats["times"]["build"] + sum(step["seconds"] for step in stats["passes"])
            for count in map(int, options.counts.split(",")):
                shards = [cpu_of([*line, "-o", f"{folder}/a.png", "--shard", f"{k}/{count}"], path.parent) for k in range(1, count + 1)]
                begin = time.time()
                subprocess.run([durer, "merge", f"{folder}/a.png", "-q"], check=True, capture_output=True)
                merge = time.time() - begin
                if pathlib.Path(folder, "a.png").read_bytes() != pathlib.Path(folder, "whole.png").read_bytes():
                    raise SystemExit(f"{scene}: {count} shards have other bytes")
                for shard in pathlib.Path(folder).glob("a.png.shard-*"):
                    shard.unlink()
                print(f"| {path.stem} | {start:.2f} s | {count} | {sum(shards) / whole:.3f} | {max(shards) * count / sum(shards):.2f} | {merge:.2f} s |", flush=True)


if __name__ == "__main__":
    main()
