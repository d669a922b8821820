#!/usr/bin/env python3
"""Makes a random scene that differs as small as it goes, so that its cause can be seen.

    shrink.py --durer PATH [--generator given | scenes.py] [--family a,b] [--tool …/random_scenes.py] [--jobs 10] SEED | FILE

Blocks and modifiers are left out, parts of CSG take the place of the whole, numbers and colours become plain, as long as the pictures
differ in at least `--share` of their pixels (or a third of what they did) and POV-Ray's own picture depends neither on the order of its
pixels (some are drawn alone) nor on the last digits of the camera. Candidates are drawn side by side: POV-Ray sleeps most of its second.
"""

import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import tempfile

from tool import TOOL, run, use

SIZE = (80, 60)

WORDS = (
    "translate rotate scale matrix turbulence phase frequency octaves omega lambda noise_generator phong phong_size specular roughness ambient diffuse "
    "brilliance emission ior fade_distance fade_power fade_color caustics dispersion dispersion_samples bump_size accuracy crand "
    "max_trace_level adc_bailout number_of_waves ambient_light irid_wavelength fade_color map_type interpolate quick_color exponent "
    "sky up right direction angle look_at control0 control1 orientation dist_exp strength falloff offset flip form metric agate_turb"
).split()
BARE = (
    "no_shadow no_image no_reflection double_illuminate hollow inverse open metallic conserve_energy shadowless uv_mapping "
    "cutaway_textures once no_bump_scale sine_wave triangle_wave ramp_wave scallop_wave cubic_wave fresnel albedo"
).split()
OBJECTS = (
    "sphere box cylinder cone torus disc triangle smooth_triangle polygon plane quadric cubic quartic poly polynomial superellipsoid lathe sor "
    "prism mesh mesh2 text blob union intersection difference merge object"
).split()
VALUE = r"(?:(?:srgb|rgbf|rgbt|rgbft|rgb|color)\s*)*(?:<[^<>]*>|-?[\d.]+(?:/\d+)?(?:e-?\d+)?)(?:\s*\*\s*(?:[xyz]\b|[\d.]+))?"


def spans(text):
    """(word, start, inner start, end) of each `word { … }`, and of each `[ … ]`."""
    out, stack = [], []
    for m in re.finditer(r"[\w]*\s*\{|\}|\[|\]", text):
        if m[0] in "}]":
            if stack:
                word, start, inner = stack.pop()
                out.append((word, start, inner, m.end()))
        else:
            stack.append((m[0].rstrip("{ ").strip(), m.start(), m.end()))
    return out


def has_empty_csg(text):
    """Does it have CSG without parts? That leads astray: POV-Ray has its own thoughts about it."""
    all_blocks = spans(text)
    solids = [(a, b) for word, a, _, b in all_blocks if word in OBJECTS]
    groups = [(i, e) for word, _, i, e in all_blocks if word in ("union", "merge", "intersection", "difference")]
    return any(not any(i <= a and b < e for a, b in solids) for i, e in groups)


def candidates(text):
    """(start, end, new text) of the edits to try, the greatest step first."""
    out = []

    def edit(start, end, new):
        if len(new) < end - start:
            out.append((end - start - len(new), start, end, new))

    blocks = spans(text)
    for word, start, inner, end in blocks:
        edit(start, end, "")
        if word in OBJECTS:
            for part, a, _, b in blocks:
                if part in OBJECTS and inner <= a and b < end:
                    edit(start, end, text[a:b])
            head = re.match(r"[^a-wA-Z{}]*(?=[a-z}])", text[inner:end])
            if head and head[0].strip() and word not in ("union", "intersection", "difference", "merge"):
                for plain in ("sphere { 0, 1 ", "box { -1, 1 "):
                    edit(start, inner + head.end(), plain)
        if word == "union":
            edit(start, end, text[inner : end - 1])
        if word in ("merge", "difference", "intersection"):
            edit(start, inner - 1, "union ")
        if word == "pigment":
            for plain in ("rgb 1", "rgb <1, 0, 0>", "rgbf 0.8", "rgbt 0.8"):
                edit(inner, end - 1, f" {plain} ")
        if word in ("color_map", "pigment_map", "texture_map", "normal_map"):
            edit(start, end, "color_map { [0 rgb 0] [1 rgb 1] }")
    for word in WORDS:
        for m in re.finditer(rf"\b{word}\s+{VALUE}", text):
            edit(m.start(), m.end(), "")
    for m in re.finditer(r"#macro .*?\n#end|#while .*?\n#end|#for .*?\n#end|#declare \w+ = (?=\s)", text, re.DOTALL):
        edit(m.start(), m.end(), "")
    for m in re.finditer(rf"\b({'|'.join(BARE)})\b|, -?[\d.]+(?= *[a-z}}])|#default[^\n]*", text):
        edit(m.start(), m.end(), "")
    eyes = [(a, b) for word, a, _, b in blocks if word in ("camera", "light_source")]
    for m in re.finditer(r"<[^<>]*>", text):
        # (An eye or a light at the origin leads astray.)
        if any(a < m.start() < b for a, b in eyes):
            continue
        for plain in ("0", "1", "<1, 0, 0>", "<0, 1, 0>", "<0, 0, 1>"):
            edit(m.start(), m.end(), plain)
    for m in re.finditer(r"(?<![\w.])-?\d*\.\d{2,}(?![\w.])", text):
        for digits in (0, 1):
            edit(m.start(), m.end(), f"{round(float(m[0]), digits):g}")
    out.sort(key=lambda c: -c[0])
    return [edit[1:] for edit in out]


def name_of(text, edit):
    """What an edit is called, wherever in the text it stands by then."""
    start, end, new = edit
    return text[start:end], new, text[max(0, start - 9) : start]


def edited(text, edits):
    """The text after edits, of which those that overlap with one before are left out; None where that is no scene."""
    taken = []
    for start, end, new in edits:
        if all(end <= a or b <= start for a, b, _ in taken):
            taken.append((start, end, new))
    for start, end, new in sorted(taken, reverse=True):
        text = text[:start] + new + text[end:]
    text = re.sub(r"[ \t]+", " ", text)
    return text if "camera" in text and "light_source" in text and not has_empty_csg(text) else None


class Judge:
    """Draws a scene with both programs."""

    def __init__(self, durer, tool, share):
        self.durer, self.tool, self.share = durer, tool, share

    def povray(self, text, folder, *words):
        import numpy
        from PIL import Image

        (folder / "p.pov").write_text(text)
        (folder / "p.png").unlink(missing_ok=True)
        words = ["povray", "+Ip.pov", "+Op.png", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-A", "-D", "-GA", "+WT1", *words]
        done = run(words, folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=60)
        if done.returncode or not (folder / "p.png").exists():
            return None
        return numpy.asarray(Image.open(folder / "p.png").convert("RGB")).astype(int)

    def ours(self, text, folder):
        import numpy
        from PIL import Image

        (folder / "d.pov").write_text(text)
        (folder / "d.png").unlink(missing_ok=True)
        words = [self.durer, "render", "d.pov", "-o", "d.png", "--size", f"{SIZE[0]}x{SIZE[1]}", "--aa", "off", "--threads", "1", "--progress", "never"]
        done = run(words, folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=60)
        if done.returncode or not (folder / "d.png").exists():
            return None
        return numpy.asarray(Image.open(folder / "d.png").convert("RGB")).astype(int)

    def by_order(self, text, folder, theirs, ours):
        """Is POV-Ray's pixel the same as ours where it is drawn alone? Then it depends on those drawn before."""
        import numpy

        ys, xs = numpy.nonzero(abs(theirs - ours).max(-1) > 2)
        chosen = list(zip(ys, xs))[:: max(1, len(ys) // 5)][:5]
        same = 0
        for y, x in chosen:
            alone = self.povray(text, folder, f"+SC{x + 1}", f"+EC{x + 1}", f"+SR{y + 1}", f"+ER{y + 1}")
            same += alone is not None and abs(alone[y, x] - ours[y, x]).max() <= 2
        return bool(chosen) and same * 2 > len(chosen)

    @staticmethod
    def moved(text, way=0):
        """The scene with its camera a billionth away, in one of eight ways."""
        by = [f"{-size if way >> axis & 1 else size}e-9" for axis, size in enumerate((1, 2, 1))]
        return re.sub(r"(camera \{[^}]*)\}", rf"\1 translate <{', '.join(by)}> }}", text, count=1)

    def differs(self, text, prove=True):
        """The share of pixels that differ; 0 where POV-Ray does not know it itself, which takes eight pictures more to prove."""
        try:
            with tempfile.TemporaryDirectory() as folder:
                folder = pathlib.Path(folder)
                ours = self.ours(text, folder)
                theirs = self.povray(text, folder) if ours is not None else None
                if theirs is None:
                    return 0.0
                share = self.tool.apart(theirs, ours)
                if share < self.share:
                    return 0.0
                if not prove:
                    return share
                other = self.povray(self.moved(text), folder)
                if other is None or self.tool.apart(theirs, other) > share / 4 or self.by_order(text, folder, theirs, ours):
                    return 0.0
                return share
        except subprocess.TimeoutExpired:
            return 0.0


def shrink(judge, text, pool, jobs):
    """(What failed once is tried again only when nothing else is left.)"""
    failed, shrunk = set(), False
    while True:
        batch = []
        for edit in candidates(text):
            less = edited(text, [edit]) if name_of(text, edit) not in failed and len(batch) < jobs else None
            if less is not None:
                batch.append((edit, less))
        if not batch:
            if not shrunk:
                return text
            failed, shrunk = set(), False
            continue
        shares = list(pool.map(lambda row: judge.differs(row[1], prove=False), batch))
        failed |= {name_of(text, edit) for (edit, _), share in zip(batch, shares) if not share}
        good = [edit for (edit, _), share in zip(batch, shares) if share]
        # All of them together, half of them, or the first that holds alone.
        for some in (good, good[: len(good) // 2], *([edit] for edit in good)):
            less = edited(text, some) if some else None
            if less is not None and judge.differs(less):
                text, shrunk = less, True
                break
            if len(some) == 1:
                failed.add(name_of(text, some[0]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", help="a seed, or a file")
    parser.add_argument("--durer", required=True)
    parser.add_argument("--tool", default=TOOL)
    parser.add_argument("--generator", default="scenes.py")
    parser.add_argument("--family")
    parser.add_argument("--share", type=float, default=0.004)
    parser.add_argument("--jobs", type=int, default=10)
    options = parser.parse_args()
    tool = use(options.tool, options.generator)
    if options.scene.isdigit():
        wanted = options.family.split(",") if options.family else None
        seed = int(options.scene)
        text = tool.GENERATOR(seed, tool.families_of(seed, wanted)).text()
    else:
        text = pathlib.Path(options.scene).read_text()
    judge = Judge(str(pathlib.Path(options.durer).resolve()), tool, options.share)
    first = judge.differs(text)
    if not first:
        print(f"// {options.scene}: POV-Ray's picture depends on the order of its pixels or on the camera's last digits, or nothing differs")
        return 1
    judge.share = max(options.share, min(first / 3, 0.02))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        text = shrink(judge, text, pool, options.jobs)
    print(f"// {options.scene}: {judge.differs(text):.2%} of the pixels differ\n{text}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
