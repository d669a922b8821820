"""pyNeuroML: `pynml-povray` writes a scene or an INI file of a movie, and prints the line to type; `OverlaySimulation` writes a script
of lines.
"""

from clients import Case

SCENE = """/*
POV-Ray file generated from NeuroML network
*/
#version 3.6;
#include "colors.inc"
background {rgbt <0,0,0,0.55>}
#declare cell_0 =
union {
    sphere {
        <0, 0, 0>, 8
        pigment { color rgb <0.9,0.4,0.2> }
    }
    cone {
        <0, 6, 0>, 2,
        <0, 40, 5>, 1
        pigment { color rgb <0.9,0.4,0.2> }
    }
}
#declare net = union {
    object { cell_0 translate <-20, 0, 0> }
    object { cell_0 rotate y*50 translate <18, -6, 10> }
}
object { net }
camera {
    location < 0 , 10 , -110 >
    rotate <0, 360*clock, 0>
    look_at <0, 12, 0>
}
light_source { <300, 500, -800> color rgb <2,2,2> }
"""

MOVIE = """
Antialias=On

+W80 +H60

Antialias_Threshold=0.3
Antialias_Depth=4

Input_File_Name=net.pov

Initial_Frame=1
Final_Frame=3
Initial_Clock=0
Final_Clock=1

Cyclic_Animation=on
Pause_when_Done=off

        """


def scene(line):
    """Creates an action that runs a line with the scene's name at its end."""

    def action(box):
        box.write("net.pov", SCENE)
        box.shell(line)

    return action


def movie(box):
    """Runs the line for a movie."""
    box.write("net.pov", SCENE)
    box.write("net_movie.ini", MOVIE)
    box.shell("povray net_movie.ini")


def overlay(box):
    """Runs a script with one line for each frame, with absolute names of scenes."""
    for frame in (0, 1):
        box.write(f"net_T{frame}.pov", SCENE.replace("clock", str(frame / 4)))
    options = "-D Antialias=On Antialias_Depth=10 Antialias_Threshold=0.1 +W80 +H60"
    lines = [f"povray {options} {box.folder}/net_T{frame}.pov\n" for frame in (0, 1)]
    box.write("net_pov.sh", "".join(lines))
    box.shell("bash net_pov.sh")


CASES = [
    Case("line", scene("povray Antialias=On Antialias_Depth=10 Antialias_Threshold=0.1 +W96 +H72 net.pov")),
    Case("movie", movie),
    Case("overlay", overlay),
]
