"""Runs programs that call `povray` once with POV-Ray and once with durer, and compares what they get.

A script in `programs/` describes a program, or a family of command lines, by a list `CASES` of `Case`. The action of a case receives a
`Box`: an empty folder whose `PATH` begins with a link named `povray`. The action runs twice, with the link to POV-Ray and with the link to
durer, and records what the program reads back. Three kinds of data are compared:

- Files: path below the box, kind (`file`, `folder`, `link`), for every file that exists at the end. The box's own folders do not count.
- Records: `(name, value)` pairs in the order of the action: exit codes (`box.run`), parsed lines and numbers (`box.record`). The path of
  the box is replaced by `<box>` in texts.
- Pictures: every file whose first bytes are those of PNG, PPM, PGM, TGA (by its ending), BMP or JPEG, and standard output where the action
  passes it to `box.picture`. Format, width, height, channels and bits per channel must be equal.

Samples are compared in steps of 8 bits. A pixel of a picture agrees with the other picture if each channel lies between the least and the
largest value in the 3x3 pixels around the same place there, or at most `PIXEL_STEPS` outside. The neighbours count because the samples of
POV-Ray's anti-aliasing are random, which shows at edges. At most the part `PIXEL_SHARE` of the pixels of each picture may disagree, the
mean difference of all channels of the same pixels may be at most `MEAN_STEPS`, and the mean of the signed differences, which random samples
do not change, at most `BIAS_STEPS`. Colours of pixels without opacity count as black. Pixels of JPEG
files are not compared, because Python's standard library does not decode them.
"""

import os
import re
import shutil
import struct
import subprocess
import sys
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

# Largest distance of a channel from the range of the neighbours in the other picture, of 255.
PIXEL_STEPS = 3
# Largest part of a picture's pixels that may disagree.
PIXEL_SHARE = 0.005
# Largest mean difference of all channels, of 255.
MEAN_STEPS = 3
# Largest mean of the signed differences, of 255.
BIAS_STEPS = 0.3
# Seconds after which a program is stopped.
TIMEOUT = 60

# Python interpreter that runs the clients that are packages of PyPI; `run.py` sets it.
PYTHON = [sys.executable]


@dataclass
class Case:
    """A way in which a program uses `povray`."""

    # Name after the program's name, such as `border`.
    name: str
    # Runs the program in the box and records what it reads back.
    action: Callable[["Box"], None]
    # Programs (`obabel`), Python modules (`python:ase`) or absolute files that must exist.
    needs: tuple = ()
    # True if POV-Ray draws at least one picture.
    draws: bool = True
    # Beginning of the difference that is known and not yet resolved; empty for a case that must agree.
    known: str = ""

    def missing(self):
        """Returns the first need that is not installed, or `None`."""
        return next((need for need in self.needs if not is_installed(need)), None)


def is_installed(need):
    """True if a program, a Python module or a file exists."""
    if need.startswith("python:"):
        check = f"import importlib.util as u, sys; sys.exit(u.find_spec({need[7:]!r}) is None)"
        return subprocess.run([*PYTHON, "-c", check], cwd="/", capture_output=True).returncode == 0
    return Path(need).exists() if need.startswith("/") else shutil.which(need) is not None


@dataclass
class Outcome:
    """Result of an action with one renderer."""

    # Kind of each path below the box.
    files: dict = field(default_factory=dict)
    # What the program reads back, and exit codes.
    records: list = field(default_factory=list)
    pictures: dict = field(default_factory=dict)
    # End of standard error of each program, for `--verbose`.
    messages: list = field(default_factory=list)


class Box:
    """Empty folder with a `povray` of its own."""

    def __init__(self, root, renderer):
        self.root = Path(root)
        self.folder = self.root / "work"
        self.temporary = self.root / "tmp"
        self.outcome = Outcome()
        for folder in (self.folder, self.temporary, self.root / "home", self.root / "bin"):
            folder.mkdir(parents=True)
        (self.root / "bin/povray").symlink_to(renderer)
        self.environment = {
            "PATH": f"{self.root / 'bin'}:{os.environ['PATH']}",
            "HOME": str(self.root / "home"),
            "TMPDIR": str(self.temporary),
            "LC_ALL": "C.UTF-8",
            # POV-Ray's preview (`+D`) finds no display. Otherwise POV-Ray draws into the terminal, and `+P` waits for a key.
            "SDL_VIDEODRIVER": "x11",
            "MPLCONFIGDIR": str(self.root / "home/matplotlib"),
        }

    def write(self, name, text):
        """Writes a text file below the work folder and returns its path."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def run(self, *command, cwd=None, text=True, merge=False, name="exit code"):
        """Runs a program and records its exit code. `merge` joins standard error to standard output."""
        words = [str(word) for word in command]
        return self._recorded(words, cwd, text, merge, name, shell=False)

    def shell(self, line, cwd=None, text=True, merge=False, name="exit code"):
        """Runs a line of `sh`, as `system()` and `subprocess.run(…, shell=True)` do, and records its exit code."""
        return self._recorded(line, cwd, text, merge, name, shell=True)

    def python(self, script, cwd=None):
        """Runs a script in the Python with the packages of PyPI and records its exit code and the lines that begin with `read `."""
        result = self.run(*PYTHON, "-c", script, cwd=cwd, name="exit code of Python")
        self.record("lines", [line for line in result.stdout.splitlines() if line.startswith("read ")])
        return result

    def _recorded(self, command, cwd, text, merge, name, shell):
        result = subprocess.run(
            command,
            cwd=cwd or self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT if merge else subprocess.PIPE,
            timeout=TIMEOUT,
            shell=shell,
        )
        if text:
            result.stdout = result.stdout.decode(errors="replace")
        result.stderr = (result.stderr or b"").decode(errors="replace")
        self.record(name, result.returncode)
        self.outcome.messages.append(str(result.stdout)[-1500 * merge :] if merge else result.stderr[-1500:])
        return result

    def record(self, name, value):
        """Records a value that the program reads back."""
        self.outcome.records.append((name, self.without_path(value)))

    def without_path(self, value):
        """Replaces the path of the box in texts and lists of texts."""
        if isinstance(value, (list, tuple)):
            return [self.without_path(item) for item in value]
        return value.replace(str(self.root), "<box>") if isinstance(value, str) else value

    def picture(self, name, data):
        """Records a picture that is not a file."""
        self.outcome.pictures[name] = decode(data, Path(name).suffix)

    def finish(self):
        """Collects the files of the box, and returns the outcome."""
        for path in sorted(self.root.rglob("*")):
            name = path.relative_to(self.root)
            if name.parts[0] in ("bin", "home") or len(name.parts) == 1:
                continue
            kind = "link" if path.is_symlink() else "folder" if path.is_dir() else "file"
            self.outcome.files[str(name)] = kind
            if kind == "file":
                picture = decode(path.read_bytes(), path.suffix)
                if picture is not None:
                    self.outcome.pictures[str(name)] = picture
        return self.outcome


def find_all(pattern, text):
    """Returns all matches of a regular expression, as programs search for them."""
    return re.findall(pattern, text, re.MULTILINE)


# ---- Pictures


@dataclass
class Picture:
    """Decoded picture; `pixels` is `None` for a format that is not decoded."""

    format: str
    width: int
    height: int
    channels: int
    bits: int
    # Samples in steps of 8 bits as floats, row by row, from the top left.
    pixels: list = None

    def shape(self):
        """Returns the values that must be equal."""
        return (self.format, self.width, self.height, self.channels, self.bits)


def decode(data, suffix):
    """Decodes a picture file; returns `None` for other files. Raises `ValueError` for a broken picture."""
    if data.startswith(b"\x89PNG"):
        return decode_png(data)
    if data[:2] in (b"P5", b"P6"):
        return decode_netpbm(data)
    if data.startswith(b"BM"):
        return decode_bmp(data)
    if data.startswith(b"\xff\xd8\xff"):
        return decode_jpeg(data)
    return decode_tga(data) if suffix.lower() == ".tga" and data else None


def samples(data, bits):
    """Returns samples of 8 or 16 bits (high byte first) in steps of 8 bits."""
    if bits == 8:
        return list(map(float, data))
    return [n / 257 for n in struct.unpack(f">{len(data) // 2}H", data)]


def decode_png(data):
    """Decodes PNG of 8 or 16 bits without interlacing."""
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    if bits not in (8, 16) or color not in (0, 2, 4, 6) or interlaced:
        raise ValueError(f"PNG with {bits} bits, colour type {color}")
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
    step = channels * bits // 8
    rows, raw, row = b"", zlib.decompress(packed), bytes(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        row = unfiltered(raw[start], bytearray(raw[start + 1 : start + 1 + width * step]), row, step)
        rows += row
    return Picture("PNG", width, height, channels, bits, samples(rows, bits))


def unfiltered(kind, row, above, step):
    """Reverses the filter of a PNG row (PNG specification, section 9)."""
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        up, corner = above[i], above[i - step] if i >= step else 0
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + up) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + up) // 2) & 255
        elif kind == 4:
            estimate = left + up - corner
            distances = [(abs(estimate - value), order, value) for order, value in enumerate((left, up, corner))]
            row[i] = (row[i] + min(distances)[2]) & 255
    return bytes(row)


def decode_netpbm(data):
    """Decodes binary PGM and PPM."""
    header = re.match(rb"P([56])\s(?:\s*#.*\n)*\s*(\d+)\s+(\d+)\s+(\d+)\s", data)
    width, height, largest = (int(header[i]) for i in (2, 3, 4))
    channels, bits = 3 if header[1] == b"6" else 1, 8 if largest < 256 else 16
    body = data[header.end() :]
    if len(body) != width * height * channels * bits // 8:
        raise ValueError(f"netpbm file of {width}x{height} has {len(body)} bytes of pixels")
    return Picture("PPM" if channels == 3 else "PGM", width, height, channels, bits, samples(body, bits))


def decode_tga(data):
    """Decodes true-colour TGA of 24 or 32 bits, plain or run-length encoded."""
    comment, _, kind = data[:3]
    width, height, depth, flags = struct.unpack_from("<HHBB", data, 12)
    step, at, body = depth // 8, 18 + comment, b""
    if kind not in (2, 10) or step not in (3, 4):
        raise ValueError(f"TGA of type {kind} with {depth} bits")
    if kind == 2:
        body = data[at : at + width * height * step]
    while kind == 10 and len(body) < width * height * step:
        count, at = (data[at] & 127) + 1, at + 1
        is_run = data[at - 1] & 128
        size = step if is_run else count * step
        body += data[at : at + size] * (count if is_run else 1)
        at += size
    rows = [body[y * width * step : (y + 1) * width * step] for y in range(height)]
    if not flags & 0x20:
        rows.reverse()
    return Picture("TGA" if kind == 2 else "TGA (compressed)", width, height, step, 8, blue_first(b"".join(rows), step))


def decode_bmp(data):
    """Decodes uncompressed BMP of 24 or 32 bits."""
    offset, _, width, height, _, depth = struct.unpack_from("<IIiiHH", data, 10)
    step = depth // 8
    stride = (width * step + 3) // 4 * 4
    rows = [data[offset + y * stride : offset + y * stride + width * step] for y in range(abs(height))]
    if height > 0:
        rows.reverse()
    return Picture("BMP", width, abs(height), step, 8, blue_first(b"".join(rows), step))


def blue_first(body, step):
    """Returns samples of pixels whose bytes are blue, green, red."""
    out = bytearray(body)
    out[0::step], out[2::step] = body[2::step], body[0::step]
    return samples(bytes(out), 8)


def decode_jpeg(data):
    """Reads size and channels of a JPEG file."""
    at = 2
    while at + 9 < len(data):
        marker, length = data[at + 1], struct.unpack_from(">H", data, at + 2)[0]
        if marker in (0xC0, 0xC1, 0xC2):
            bits, height, width, channels = struct.unpack_from(">BHHB", data, at + 4)
            return Picture("JPEG", width, height, channels, bits)
        at += length + 2
    raise ValueError("JPEG file without a frame")


# ---- Comparison


@dataclass
class Report:
    """Result of a comparison."""

    differences: list = field(default_factory=list)
    # Mean difference of each compared picture, of 255.
    means: list = field(default_factory=list)


def compare(povray, durer):
    """Compares the outcomes of POV-Ray and of durer."""
    report = Report()
    for name in sorted(povray.files.keys() | durer.files.keys()):
        ours, theirs = durer.files.get(name, "nothing"), povray.files.get(name, "nothing")
        if ours != theirs:
            report.differences.append(f"{name}: POV-Ray leaves a {theirs}, durer a {ours}".replace("a nothing", "nothing"))
    if [name for name, _ in povray.records] != [name for name, _ in durer.records]:
        report.differences.append(f"records: POV-Ray {povray.records}, durer {durer.records}")
    for (name, theirs), (_, ours) in zip(povray.records, durer.records):
        if theirs != ours:
            report.differences.append(f"{name}: POV-Ray {theirs!r}, durer {ours!r}")
    for name in sorted(povray.pictures.keys() & durer.pictures.keys()):
        compare_pictures(name, povray.pictures[name], durer.pictures[name], report)
    for name in sorted(povray.pictures.keys() ^ durer.pictures.keys()):
        report.differences.append(f"{name}: a picture with only one of POV-Ray and durer")
    return report


def compare_pictures(name, theirs, ours, report):
    """Compares two pictures and adds the result to the report."""
    if theirs is None or ours is None or theirs.shape() != ours.shape():
        shapes = [picture.shape() if picture else "no picture" for picture in (theirs, ours)]
        report.differences.append(f"{name}: POV-Ray {shapes[0]}, durer {shapes[1]}")
        return
    if theirs.pixels is None:
        return
    a, b = visible(theirs), visible(ours)
    mean = sum(abs(x - y) for x, y in zip(a, b)) / len(a)
    bias = abs(sum(a) - sum(b)) / len(a)
    share = max(disagreeing(theirs, a, b), disagreeing(theirs, b, a))
    report.means.append(mean)
    if mean > MEAN_STEPS or bias > BIAS_STEPS or share > PIXEL_SHARE:
        means = f"mean difference {mean:.3f} of 255, signed {bias:.3f}"
        report.differences.append(f"{name}: {100 * share:.2f} % of the pixels disagree, {means}")


def visible(picture):
    """Returns the samples of a picture, where pixels without opacity are black."""
    n = picture.channels
    if n in (1, 3):
        return picture.pixels
    out = list(picture.pixels)
    for i in range(0, len(out), n):
        if out[i + n - 1] == 0:
            out[i : i + n] = [0.0] * n
    return out


def disagreeing(picture, a, b):
    """Returns the part of the pixels of `a` that disagree with `b`; both have the size of `picture`."""
    n, stride, count = picture.channels, picture.width * picture.channels, 0
    for y in range(picture.height):
        rows = range(max(y - 1, 0), min(y + 2, picture.height))
        for at in range(y * stride, (y + 1) * stride, n):
            if all(abs(a[at + c] - b[at + c]) <= PIXEL_STEPS for c in range(n)):
                continue
            left, right = max(at - n - y * stride, 0), min(at + 2 * n - y * stride, stride)
            for c in range(n):
                around = [value for row in rows for value in b[row * stride + left + c : row * stride + right : n]]
                if not min(around) - PIXEL_STEPS <= a[at + c] <= max(around) + PIXEL_STEPS:
                    count += 1
                    break
    return count / (picture.width * picture.height)
