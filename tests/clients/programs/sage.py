"""SageMath: `povray(scene, outfile=…, W=…, H=…)` runs one line of a shell, with `+FP` and the words of the call."""

from clients import Case

SCENE = """#include "colors.inc"
camera { location <4, 3, 3> look_at <0, 0, 0> sky <0, 0, 1> up z right -1.33*x direction y angle 35 }
light_source { <6, 2, 8> color White }
background { color rgb <0.8, 0.9, 1> }
#declare wire = 0.06;
union {
  sphere { <0, 0, 0>, 0.7 }
  cylinder { <-1, 0, 0>, <1, 0, 0>, wire }
  cylinder { <0, -1, 0>, <0, 1, 0>, wire }
  cylinder { <0, 0, -1>, <0, 0, 1>, wire }
  pigment { color Orange } finish { phong 0.5 }
}
"""


def render(outfile, **words):
    """Creates an action that builds the line as the interface does. The interface ignores the exit code."""

    def action(box):
        box.write("surface.pov", SCENE)
        options = "".join(f"+{name}{value} " for name, value in words.items())
        box.shell(f"povray -D +FP +Isurface.pov +O{box.folder}/{outfile} {options}")

    return action


CASES = [Case("default", render("sage.ppm", W=80, H=60)), Case("words", render("out.ppm", W=80, H=60, A=0.2, Q=9))]
