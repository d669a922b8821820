#!/usr/bin/env python3
"""Names likely causes of scenes that differ: draws each again without what is known to make a difference (see README.md).

    without.py --durer PATH [--generator given | scenes.py] [--tool …/random_scenes.py] SEED…

A line for each seed: the share of the pixels that differ, and without what they are how many.
"""

import argparse
import concurrent.futures
import pathlib
import re
import tempfile

from shrink import Judge, spans
from tool import TOOL, use


def without_blocks(word, text):
    """The text without `word { … }`."""
    for found, start, _, end in sorted(spans(text), key=lambda span: -span[1]):
        if found.split()[-1:] == [word]:
            text = text[:start] + text[end:]
    return text


def bailing_late(text):
    """With an `adc_bailout` that ends no ray early."""
    text = re.sub(r"\badc_bailout [\d.]+", "", text)
    return re.sub(r"^", "global_settings { adc_bailout 0.00001 }\n", text, count=1)


WITHOUT = {
    "inverse": lambda text: re.sub(r"\binverse\b", "", text),
    "sturm": lambda text: re.sub(r"\bsturm\b", "", text),
    "once": lambda text: re.sub(r"\bonce\b", "", text),
    "clipped_by": lambda text: without_blocks("clipped_by", text),
    "dispersion": lambda text: re.sub(r"\bdispersion(_samples)? [\d.]+", "", text),
    "adc_bailout": bailing_late,
    "normal": lambda text: without_blocks("normal", text),
    "interior_texture": lambda text: without_blocks("interior_texture", text),
    "fog": lambda text: without_blocks("fog", text),
    "reflection": lambda text: without_blocks("reflection", text),
    "interior": lambda text: without_blocks("interior", text),
    "area_light": lambda text: re.sub(r"\barea_light (<[^>]*>|[-\w.*]+), *(<[^>]*>|[-\w.*]+), *\d+, *\d+", "", text),
    "uv_mapping": lambda text: re.sub(r"\buv_mapping\b", "", text),
    "slope and aoi": lambda text: re.sub(r"\b(slope|aoi)\b( *\{[^}]*\}| *<[^>]*>)?", "bozo", text),
    "highlights": lambda text: re.sub(r"\b(phong|specular) [-\d.]+", "", text),
    "irid": lambda text: without_blocks("irid", text),
    "turbulence": lambda text: re.sub(r"\bturbulence (<[^>]*>|[-\d.]+)", "", text),
}


def share(judge, text):
    """How many pixels differ, or None where a program fails."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        theirs, ours = judge.povray(text, folder), judge.ours(text, folder)
    return None if theirs is None or ours is None else (abs(theirs - ours).max(-1) > 2).mean()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--durer", required=True, type=pathlib.Path)
    parser.add_argument("--tool", default=TOOL)
    parser.add_argument("--generator", default="given")
    parser.add_argument("seeds", nargs="+", type=int)
    options = parser.parse_args()
    tool = use(options.tool, options.generator)
    judge = Judge(str(options.durer.resolve()), tool, 0)
    told = lambda part: "not drawn" if part is None else f"{part:.2%}"
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        for seed in options.seeds:
            text = tool.GENERATOR(seed, tool.families_of(seed, None)).text()
            texts = {"": text} | {name: changed for name, change in WITHOUT.items() if (changed := change(text)) != text}
            shares = dict(zip(texts, pool.map(lambda one: share(judge, one), texts.values())))
            rest = ", ".join(f"without {name} {told(part)}" for name, part in shares.items() if name)
            print(f"{seed}: {told(shares[''])}; {rest}", flush=True)


if __name__ == "__main__":
    main()
