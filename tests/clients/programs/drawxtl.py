"""DRAWxtl: runs `povray` with the options of its configuration dialogue on a scene beside the structure file; frames of modulated
structures become one picture each, with options that silence all messages.
"""

from clients import Case

SCENE = """/* scene written in the style of DRAWxtl */
#version 3.6;
#include "colors.inc"
background{White}
camera { orthographic
   location <0,0,{phase}>
   right <-4,0,0>
   up <0,3,0>
   sky <0,1,0>
   look_at <0,0,0>
}
light_source { <10,20,40> color White shadowless }
#default { finish { ambient 0.3 diffuse 0.7 phong 0.3 phong_size 40 } }
/* spheres */
sphere { <-0.8, 0.1, 0.3>, 0.6 texture { pigment { color Red } } }
sphere { <0.9, -0.3, -0.2>, 0.5 texture { pigment { color Blue filter 0.3 } } }
/* bond */
cylinder { <-0.8, 0.1, 0.3>, <0.9, -0.3, -0.2>, 0.12 texture { pigment { color Gray60 } } }
/* polyhedron */
union {
triangle { <0,1,0>, <0.5,0.2,0.6>, <-0.5,0.2,0.6> }
triangle { <0,1,0>, <0.5,0.2,0.6>, <0.4,0.2,-0.6> }
 texture { pigment { color Green filter 0.6 } } }
"""


def options(words, name):
    """Creates an action with options as a user enters them."""

    def action(box):
        box.write("quartz.pov", SCENE.replace("{phase}", "20"))
        box.shell(f"povray {words} quartz.pov", name=f"exit code {name}")

    return action


def frames(ending, kind):
    """Creates an action that renders numbered scenes in the folder of the movie."""

    def action(box):
        for frame in (1, 2):
            scene = box.folder / f"movie{frame:03d}.pov"
            box.write(scene, SCENE.replace("{phase}", str(20 + frame)))
            name = scene.with_name(f"movie{frame:03d}.{ending}")
            line = f"povray -V -GA -GD -GF -GR -GS -GW -D -P +W64 +H48 {kind} +I{scene} +O{name}"
            result = box.shell(line, cwd=box.root)
            box.record("standard output", len(result.stdout))

    return action


CASES = [
    # POV-Ray 3.7 refuses `++D`, which DRAWxtl's default options have.
    Case("default-options", options("+W80 +H60 +D ++D +FC +A0.3 +P", "with ++D"), draws=False),
    Case("compressed-tga", options("+W80 +H60 +D +FC +A0.3 +P", "with +FC")),
    Case("png", options("+W80 +H60 -D +FN +A0.3 -P", "with +FN")),
    Case("frames-tga", frames("tga", "+FT")),
    Case("frames-png", frames("png", "+FN")),
]
