#!/usr/bin/env python3
"""Compares the tests of this folder with POV-Ray.

    regenerate.py [--write] [FILE.scene ...]

Runs `povray` on each section of each file (see tests/cases/lang.rs for the format) and compares what it prints with the `//=`
comments, and whether it fails with the `//! E…` comments. `--write` puts what POV-Ray prints into the `//=` comments.
Sections with `//~` are extensions or known differences, and are not compared.
"""

import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
LINE_END = re.compile(rb"(\r\n|\r|\n)")


def split_lines(data):
    """Lines with their ends, as bytes."""
    parts = LINE_END.split(data)
    ends = parts[1::2] + [b""]
    return [line + end for line, end in zip(parts[0::2], ends)]


def sections(lines):
    """Ranges of line numbers: the preamble first, then what each `//---` begins."""
    starts = [i for i, line in enumerate(lines) if line.startswith(b"//---")]
    bounds = [0] + starts + [len(lines)]
    return [range(a, b) for a, b in zip(bounds, bounds[1:])]


def only(lines, kept):
    """The file with all other lines blanked, so that spans keep their line numbers."""
    blank = lambda line: LINE_END.search(line)[0] if LINE_END.search(line) else b""
    return b"".join(line if i in kept else blank(line) for i, line in enumerate(lines))


def ask(text):
    """What POV-Ray prints, whether it read the scene, and its error message."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "scene.pov").write_bytes(text)
        command = ["povray", "+Iscene.pov", f"+L{FOLDER}", "+W1", "+H1", "-D", "-F", "-GA", "+GDd.txt", "+GFf.txt"]
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=60)
        read = lambda name: (folder / name).read_bytes() if (folder / name).exists() else b""
        return read("d.txt").split(b"\n")[:-1], done.returncode == 0, read("f.txt")


def check(path, write):
    """The number of differences in a file."""
    lines = split_lines(path.read_bytes())
    preamble, *cases = sections(lines)
    wrong = 0
    cases = [case for case in cases or [preamble] if not any(b"//~" in lines[i] for i in case)]
    texts = [only(lines, set(preamble) | set(case)) for case in cases]
    # POV-Ray waits more than it works.
    with concurrent.futures.ThreadPoolExecutor(12) as pool:
        answers = list(pool.map(ask, texts))
    for case, (printed, fine, complaint) in zip(cases, answers):
        marks = [i for i in case if b"//=" in lines[i]]
        fails = any(re.search(rb"//! E", lines[i]) for i in case)
        title = f"{path.name}:{case.start + 1}"
        if fine == fails:
            wrong += 1
            print(f"{title}: POV-Ray {'reads it' if fine else 'fails'}\n{complaint.decode('latin-1')}")
        expected = [re.split(rb"//= ?", lines[i])[1].rstrip(b"\r\n") for i in marks]
        if fails:
            expected = expected[: len(printed)]
        if len(printed) != len(expected):
            wrong += 1
            print(f"{title}: {len(expected)} lines expected, POV-Ray prints {len(printed)}:")
            print("\n".join("    " + p.decode("latin-1") for p in printed))
            continue
        for i, old, new in zip(marks, expected, printed):
            if old != new and write:
                head, _ = re.split(rb"//=", lines[i])
                end = LINE_END.search(lines[i])
                lines[i] = head + b"//= " + new + (end[0] if end else b"")
            elif old != new:
                wrong += 1
                print(f"{path.name}:{i + 1}: expected {old!r}, POV-Ray prints {new!r}")
    if write:
        path.write_bytes(b"".join(lines))
    return wrong


def main():
    words = sys.argv[1:]
    files = [pathlib.Path(w) for w in words if w != "--write"] or sorted(FOLDER.glob("*.scene"))
    wrong = sum(check(path, "--write" in words) for path in files)
    print(f"{len(files)} files, {wrong} differences")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
