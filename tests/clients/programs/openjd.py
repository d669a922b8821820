"""Open Job Description: `openjd run` runs a job template whose tasks call `povray` for one frame each; a task fails by its exit code."""

import sys
from clients import PYTHON, Case
from pathlib import Path

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 right x*image_width/image_height }
light_source { <4, 6, -5> rgb 1 }
sphere { x*(clock - 0.5)*2, 0.8 pigment { rgb <1, clock, 0> } }
plane { y, -0.8 pigment { rgb 0.6 } }
#if (frame_number > %d) #error "no such frame" #end
"""

TEMPLATE = """specificationVersion: jobtemplate-2023-09
name: Frames
parameterDefinitions:
  - {name: Folder, type: PATH, objectType: DIRECTORY, dataFlow: INOUT}
steps:
  - name: Render
    parameterSpace:
      taskParameterDefinitions:
        - {name: Frame, type: INT, range: "1-3"}
    script:
      actions:
        onRun:
          command: povray
          args: ["+I{{Param.Folder}}/scene.pov", "+O{{Param.Folder}}/frame.png", "+W64", "+H48", "+KFI1", "+KFF3",
                 "+SF{{Task.Param.Frame}}", "+EF{{Task.Param.Frame}}", "-D"]
"""


def render(last_frame):
    """Creates an action whose scene fails after a frame."""

    def action(box):
        box.write("scene.pov", SCENE % last_frame)
        template = box.write("job.template.yaml", TEMPLATE)
        program = Path(PYTHON[0]).with_name("openjd")
        result = box.run(program, "run", template, "-p", f"Folder={box.folder}", name="exit code of openjd")
        summary = [line for line in result.stdout.splitlines() if line.startswith(("Session ended", "Tasks run", "Chunks run"))]
        box.record("summary", [line.split(" (")[0] for line in summary])

    return action


CASES = [Case("frames", render(3), needs=("python:openjd.cli",)), Case("failed-frame", render(1), needs=("python:openjd.cli",))]
