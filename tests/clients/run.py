"""Runs programs that call `povray` with POV-Ray and with durer as `povray`, and compares files, pictures, exit codes and parsed lines.

    python3 tests/clients/run.py --durer target/debug/durer [--install] [NAME…]

NAME is a program (`blender`) or a case (`blender/border`). One line per case: `ok`, `known:` (a difference that is marked in the case),
`differs:` or `skipped: not installed`. The exit code is 1 if a case differs. `--install` installs the programs that are quickly installed:
Debian's packages with apt-get, and PyPI's packages into the virtual environment of `--venv`. `clients.py` documents formats and tolerances.
"""

import argparse
import importlib.util
import os
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import clients  # noqa: E402

DEBIAN = ["openbabel"]
PYPI = ["ase", "fdray", "openjd-cli", "plato-draw", "povplot", "vapory"]


def load(path):
    """Loads the script of a program. The script's name is not importable, because packages of PyPI have the same names."""
    spec = importlib.util.spec_from_file_location(f"client_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def install(venv):
    """Installs the programs of Debian and PyPI that are missing."""
    missing = [name for name in DEBIAN if subprocess.run(["dpkg", "-s", name], capture_output=True).returncode]
    if missing:
        root = [] if os.geteuid() == 0 else ["sudo"]
        subprocess.run([*root, "apt-get", "update"], check=True, stdout=subprocess.DEVNULL)
        command = [*root, "apt-get", "install", "-y", "--no-install-recommends", *missing]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    if not (venv / "bin/pip").exists():
        subprocess.run([sys.executable, "-m", "venv", "--clear", venv], check=True)
    subprocess.run([venv / "bin/pip", "install", "--quiet", "--disable-pip-version-check", *PYPI], check=True)


def outcome(case, renderer, root):
    """Runs a case with one renderer."""
    box = clients.Box(root, renderer)
    case.action(box)
    return box.finish()


def result(name, case, povray, durer, verbose):
    """Runs a case with both renderers. Returns a line for it, and true if the case differs."""
    missing = case.missing()
    if missing:
        return f"skipped: {name}: not installed ({missing})", False
    try:
        # Debian's POV-Ray writes below /tmp only. Both names have the same length, so that lines of messages break at the same places.
        with tempfile.TemporaryDirectory(prefix="clients", dir="/tmp") as root:
            theirs = outcome(case, povray, Path(root) / "povray")
            ours = outcome(case, durer, Path(root) / "durer_")
        report = clients.compare(theirs, ours)
    except (OSError, ValueError, subprocess.SubprocessError) as fault:
        return f"differs: {name}: {type(fault).__name__}: {fault}", True
    if case.draws != bool(theirs.pictures):
        report.differences.append("POV-Ray draws no picture" if case.draws else "POV-Ray draws a picture")
    differences = "; ".join(report.differences)
    if verbose and differences:
        differences += "".join(f"\n---- POV-Ray: {text}" for text in theirs.messages)
        differences += "".join(f"\n---- durer: {text}" for text in ours.messages)
    if differences:
        is_known = case.known and all(text.startswith(case.known) for text in report.differences)
        return f"{'known' if is_known else 'differs'}: {name}: {differences}", not is_known
    means = ", ".join(f"{mean:.3f}" for mean in report.means)
    pictures = f"pictures {means} of 255" if means else "no pictures"
    obsolete = "; its mark `known` is obsolete" if case.known else ""
    return f"ok: {name}: {len(theirs.files)} files, {len(theirs.records)} records, {pictures}{obsolete}", False


def main():
    """Runs the named cases, or all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True, type=Path)
    parser.add_argument("--povray", default=Path("/usr/bin/povray"), type=Path)
    parser.add_argument("--venv", default=Path("/tmp/durer-clients-venv"), type=Path)
    parser.add_argument("--install", action="store_true")
    parser.add_argument("--verbose", action="store_true", help="print messages of programs that differ")
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    if options.install:
        install(options.venv)
    if (options.venv / "bin/python").exists():
        clients.PYTHON[:] = [str(options.venv / "bin/python")]
    scripts = sorted((HERE / "programs").glob("*.py"))
    cases = [(f"{script.stem}/{case.name}", case) for script in scripts for case in load(script).CASES]
    wanted = [(name, case) for name, case in cases if not options.names or {name, name.split("/")[0]} & set(options.names)]
    if not wanted:
        parser.error("no case has such a name")
    start, failed, counts = time.monotonic(), 0, {}
    povray, durer = options.povray.resolve(), options.durer.resolve()
    with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        for line, differs in pool.map(lambda item: result(*item, povray, durer, options.verbose), wanted):
            print(line, flush=True)
            failed += differs
            counts[line.split(":")[0]] = counts.get(line.split(":")[0], 0) + 1
    total = ", ".join(f"{count} {word}" for word, count in sorted(counts.items()))
    print(f"{total} in {time.monotonic() - start:.0f} s")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
