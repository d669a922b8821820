"""Vapory: writes `__temp__.pov` into the current folder, sends the same text to standard input, and takes a PPM file from standard
output for a NumPy array.
"""

from clients import Case

SCRIPT = """
from vapory import *
camera = Camera("location", [0, 2, -3], "look_at", [0, 1, 2])
things = [LightSource([2, 4, -3], "color", [1, 1, 1]), Background("color", [0.1, 0.2, 0.4]),
          Sphere([0, 1, 2], 1, Texture(Pigment("color", [1, 0, 1]), Finish("phong", 0.8))),
          Plane([0, 1, 0], 0, Texture(Pigment("color", [0.6, 0.7, 0.5])))]
scene = Scene(camera, things, included=["colors.inc"])
array = scene.render(width=80, height=60, antialiasing=0.2)
print("read", array.shape, array.dtype)
open("array.ppm", "wb").write(b"P6 80 60 255\\n" + array.tobytes())
scene.render("picture.png", width=80, height=60, quality=4, output_alpha=True, remove_temp=False)
try:
    Scene(camera, [Sphere([0, 1, 2])]).render("broken.png", width=8, height=6)
except OSError as fault:
    print("read", str(fault).split(":")[0], "Parse Error" in str(fault))
"""

CASES = [Case("render", lambda box: box.python(SCRIPT), needs=("python:vapory",))]
