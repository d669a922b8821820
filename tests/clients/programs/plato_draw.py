"""plato-draw: `Scene.save("NAME.png")` writes `NAME.png.pov`, runs `povray` with input and output, and removes the scene."""

from clients import Case

SCRIPT = """
import numpy as np
import plato.draw.povray as draw
spheres = draw.Spheres(positions=[(-1, 0, 0), (1, 0.5, 0)], colors=[(0.8, 0.1, 0.1, 1), (0.1, 0.3, 0.8, 1)], radii=[0.9, 0.6])
corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2
boxes = draw.ConvexPolyhedra(positions=[(0, -1, 0)], orientations=[(0.9, 0.3, 0.2, 0.1)], colors=[(0.2, 0.6, 0.3, 1)], vertices=corners)
features = dict(ambient_light=0.4, directional_light=[(-0.3, -0.5, -0.6)])
for name, more in [("plain", {}), ("fine", dict(antialiasing=0.2, multithreading=1, transparent_background=True))]:
    scene = draw.Scene([spheres, boxes], size=(4, 3), pixel_scale=20, features={**features, **more})
    print("read", scene.save(f"{name}.png"))
print("read", draw.Scene([spheres], size=(4, 3), pixel_scale=10, features=features)._repr_png_()[:4])
"""

CASES = [Case("save", lambda box: box.python(SCRIPT), needs=("python:plato",))]
