"""fdray: runs `povray` with INI settings as words and reads the picture with Pillow. It shows standard error, from the line `[Parsing`,
if the exit code is not 0, and keeps standard error without the block of `[Rendering` otherwise.
"""

from clients import Case

SCRIPT = """
from fdray import *
import fdray
scene = Scene(Camera(30, 30), LightSource((5, 8, -6), Color("white")), Sphere((0, 0, 0), 1, Color("red")),
              Box((1, -1, -1), (1.5, 0.5, 1), Color("green", 0.5)))
for words in [dict(antialias=False), dict(antialias=0.2, output_alpha=False, quality=4, threads=1)]:
    renderer = Renderer(width=80, height=60, **words)
    picture = renderer.render(scene)
    print("read", picture.shape)
    renderer.render(scene, f"picture{len(words)}.png")
    print("read", "Rendering" in renderer.stderr, renderer.stdout)
"""

BROKEN = """
import re
from fdray.core.renderer import Renderer, RenderError
try:
    Renderer(width=8, height=6).render("camera { location -z }\\nsphere { 0, 1\\n  pigmen { rgb 1 }\\n}", "x.png")
except RenderError as fault:
    # POV-Ray breaks lines at 80 columns.
    lines = str(fault).splitlines()
    print("read", lines[:2])
    print("read", re.findall(r"File '[^']*' (line 3: Parse Error):", " ".join(str(fault).split())))
"""

CASES = [
    Case("render", lambda box: box.python(SCRIPT), needs=("python:fdray",)),
    Case("error", lambda box: box.python(BROKEN), needs=("python:fdray",), draws=False),
]
