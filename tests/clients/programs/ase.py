"""ASE: `ase.io.pov.write_pov` writes `NAME.pov` and `NAME.ini`; `render()` runs `povray NAME.ini` in the current folder and looks for
`NAME.png`.
"""

from clients import Case

SCRIPT = """
from ase import Atoms
from ase.io.pov import write_pov
atoms = Atoms("OH2", [(0, 0, 0.1), (0, 0.76, -0.47), (0, -0.76, -0.47)], cell=(3, 3, 3), pbc=True)
settings = dict(canvas_width=96, pause={pause}, transparent={transparent}, textures=["ase2", "jmol", "glass"],
                point_lights=[((5, 5, 30), "White")],
                area_light=None, celllinewidth=0.05)
inputs = write_pov("water.pov", atoms, rotation="10x,-60y", show_unit_cell=2, povray_settings=settings)
try:
    print("read", inputs.render().name)
except Exception as fault:
    print("read", type(fault).__name__)
"""

BROKEN = """
from ase.io.pov import POVRAYInputs
from pathlib import Path
Path("x.pov").write_text("sphere { 0 }")
Path("x.ini").write_text("Input_File_Name=x.pov\\nWidth=8\\nHeight=8\\nVerbose=False\\nDisplay=False\\n")
try:
    print("read", POVRAYInputs(Path("x.ini")).render().name)
except Exception as fault:
    print("read", type(fault).__name__, fault)
"""


def action(script, **words):
    """Creates an action that runs a script with values for its words."""
    return lambda box: box.python(script.format(**words) if words else script)


CASES = [
    Case("transparent", action(SCRIPT, pause=True, transparent=True), needs=("python:ase",)),
    Case("opaque", action(SCRIPT, pause=False, transparent=False), needs=("python:ase",)),
    Case("error", action(BROKEN), needs=("python:ase",), draws=False),
]
