"""Random scenes of `scenes.py` that all have media.

`media` is no word of `FAMILIES` there: one more would change what all seeds draw, those of README.md among them.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import scenes

FAMILIES = scenes.FAMILIES


class Scenes(scenes.Scenes):
    """Scenes with media beside the other families."""

    def __init__(self, seed, families):
        super().__init__(seed, {*families, "media"})
