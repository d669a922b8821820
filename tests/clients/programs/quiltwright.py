"""quiltwright: renders views of a scene in a temporary folder, which include the scene by its absolute path, and reads the version with
`povray --version`.
"""

from clients import Case, find_all

SCENE = """#include "parts.inc"
#ifndef (QW_ACTIVE) camera { location <0, 1, -5> look_at 0 } #end
light_source { <4, 6, -5> rgb 1 }
Ball
plane { y, -1 pigment { rgb <0.5, 0.6, 0.4> } }
"""

VIEW = """#version 3.7;
#declare QW_ACTIVE = 1;
#include "{scene}"
camera {{
  perspective
  location <{x}, 1, -5>
  direction <0, 0, 1.5>
  right <1.3333, 0, 0>
  up <0, 1, 0>
}}
"""


def views(box):
    """Renders two views, with the folder of the scene in the library path."""
    scene = box.write("scene/scene.pov", SCENE)
    box.write("scene/parts.inc", "#declare Ball = sphere { 0, 1 pigment { rgb <0.9, 0.5, 0.1> } }\n")
    folder = box.temporary / "views"
    folder.mkdir()
    for view, x in enumerate((-0.3, 0.3)):
        (folder / f"view{view:03d}.pov").write_text(VIEW.format(scene=scene, x=x))
        words = [f"+Iview{view:03d}.pov", f"+Oview{view:03d}.png", "+W80", "+H60", "+FN", "-D", "+Q9", "+A0.3", f"+L{scene.parent}", "+WT1"]
        box.run("povray", *words, cwd=folder)


def version(box):
    """Reads the version as quiltwright does. The exit code is not read, and the number of the version is durer's own."""
    for word in ("--version", "-version"):
        result = box.run("povray", word, name=f"exit code of {word}")
        lines = [line for line in (result.stdout + result.stderr).splitlines() if line.lower().startswith(("povray ", "pov-ray"))]
        box.record("first line", find_all(r"^POV-Ray 3\.7", lines[0] if lines else ""))


CASES = [Case("views", views), Case("version", version, draws=False)]
