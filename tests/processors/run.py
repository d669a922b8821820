#!/usr/bin/env python3
"""Proves that durer renders the same bytes on every processor and with every C library.

    run.py --durer target/release/durer [--musl DURER] [--aarch64 DURER] [--write] [--only NAME]

Renders the gallery and 40 scenes of POV-Ray's distribution (Debian's povray-examples) at 64x48 with anti-aliasing, to PNG files of
16 bits, by each of these:

    native       the processor of this machine
    avx2         an emulated processor with AVX2 and FMA, but without AVX-512 (`qemu-x86_64-static -cpu Haswell`)
    sse4.2       an emulated processor with SSE4.2 alone (`-cpu Nehalem`)
    musl         a build for x86_64-unknown-linux-musl, natively
    aarch64      a build for aarch64-unknown-linux-gnu, emulated (`qemu-aarch64-static`)

and compares the SHA-256 hashes of the files with hashes.txt, which `--write` writes from the native pictures. What is not installed or
not given is skipped. The builds are made by

    rustup target add x86_64-unknown-linux-musl aarch64-unknown-linux-gnu
    cargo build --release --bin durer --target x86_64-unknown-linux-musl
    CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc \\
        cargo build --release --bin durer --target aarch64-unknown-linux-gnu

with Debian's packages qemu-user-static, gcc-aarch64-linux-gnu and libc6-dev-arm64-cross.
"""
import argparse, concurrent.futures, hashlib, os, pathlib, random, shutil, subprocess, sys, tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
HASHES = HERE / "hashes.txt"
DISTRIBUTION = pathlib.Path("/usr/share/povray-3.7")
SECONDS = 3600


def scenes():
    """The scenes by their names: all of the gallery, and 40 of the distribution, drawn by a fixed seed."""
    found = {f"gallery/{path.name}": path for path in sorted((ROOT / "scenes/gallery").glob("*.scene"))}
    # (Scenes that index an array by the frame of an animation are errors without one.)
    others = sorted(path for path in (DISTRIBUTION / "scenes").rglob("*.pov") if b"frame_number-1" not in path.read_bytes())
    for path in random.Random(1525).sample(others, min(40, len(others))):
        found[path.relative_to(DISTRIBUTION).as_posix()] = path
    return found


def ways(options):
    """The commands that start durer, by their names; `None` for what is missing on this machine."""
    emulator = shutil.which("qemu-x86_64-static")
    arm = shutil.which("qemu-aarch64-static")
    return {
        "native": [options.durer],
        "avx2": emulator and [emulator, "-cpu", "Haswell", options.durer],
        "sse4.2": emulator and [emulator, "-cpu", "Nehalem", options.durer],
        "musl": options.musl and [options.musl],
        "aarch64": arm and options.aarch64 and [arm, "-L", "/usr/aarch64-linux-gnu", options.aarch64],
    }


def hash_of(way, path):
    """Hash of the picture that a command renders of a scene, or what it says instead."""
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder, "picture.png")
        line = [*way, "render", str(path), "--size", "64x48", "--aa", "0.3", "--bit-depth", "16", "-q", "-j1", "-o", str(picture)]
        line += ["-I", str(DISTRIBUTION / "include")]
        try:
            done = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return f"not finished in {SECONDS} s"
        if not picture.exists():
            return f"exit code {done.returncode}: {done.stderr.strip()[-200:]}"
        return hashlib.sha256(picture.read_bytes()).hexdigest()


def known_hashes():
    """The hashes of hashes.txt by the names of the scenes."""
    lines = HASHES.read_text().splitlines() if HASHES.exists() else []
    return dict(reversed(line.split("  ", 1)) for line in lines if not line.startswith("#"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ["durer", "musl", "aarch64"]:
        parser.add_argument(f"--{name}", type=os.path.abspath, required=name == "durer")
    parser.add_argument("--write", action="store_true", help="write hashes.txt from the native pictures")
    parser.add_argument("--only", action="append", help="one of the ways above")
    options = parser.parse_args()
    all_scenes = scenes()
    known, faults = known_hashes(), 0
    for name, way in ways(options).items():
        if options.only and name not in options.only:
            continue
        if not way:
            print(f"{name:8} skipped: it is not installed, or no build was given")
            continue
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = dict(zip(all_scenes, pool.map(lambda path: hash_of(way, path), all_scenes.values())))
        if options.write and name == "native":
            known = found
            head = "# SHA-256 hashes of the pictures that run.py renders, of 16 bits and 64x48 pixels.\n"
            HASHES.write_text(head + "".join(f"{value}  {scene}\n" for scene, value in found.items()))
        other = {scene: value for scene, value in found.items() if known.get(scene) != value}
        for scene, value in other.items():
            print(f"{name:8} {scene}: {value}, expected {known.get(scene)}")
        faults += len(other)
        print(f"{name:8} {len(found) - len(other)} of {len(found)} pictures have the same bytes", flush=True)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
