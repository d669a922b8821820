"""Jmol: `write POVRAY molecule.pov` writes `molecule.pov` and `molecule.pov.ini`; the dialogue "Render in POV-Ray" runs `povray` with
the INI file.

The scenes are written by this script in Jmol's style, because Jmol needs Java.
"""

from clients import Case, find_all

SCENE = """// Created by Jmol
#declare Width = 96;
#declare Height = 72;
#declare minScreenDimension = 72;
#declare showAtoms = true;
#declare noShadows = true;
camera{
  orthographic
  location < 48, 36, 0>
  right < -96, 0, 0>
  up < 0, 72, 0 >
  sky < 0, -1, 0 >
  look_at < 48, 36, 1000 >
}
background { color rgb <0.9,0.95,1> }
light_source { < -100, -100, -200>  rgb <0.6,0.6,0.6> }
#default { finish {
  ambient 0.45
  diffuse 0.84
  specular 0.22
  roughness .00001
  metallic
  phong 0.9
  phong_size 120
}}
#macro check_shadow()
 #if (noShadows)
  no_shadow
 #end
#end
#macro translucentFinish(T)
 #local shineFactor = T;
 #if (T <= 0.25)
  #declare shineFactor = (1.0-4*T);
 #end
 finish {
  ambient 0.45
  diffuse 0.84
  metallic shineFactor
  phong 0.9*shineFactor
 }
#end
#macro a(X,Y,Z,RADIUS,R,G,B,T)
 sphere{<X,Y,Z>,RADIUS
  pigment{rgbt<R,G,B,T>}
  translucentFinish(T)
  check_shadow()}
#end
#macro b(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2
  pigment{rgbt<R,G,B,T>}
  translucentFinish(T)
  check_shadow()}
#end
a(40,36,100,14,0.9,0.2,0.2,0)
a(66,48,90,10,0.95,0.95,0.95,0)
a(20,20,110,8,0.2,0.4,0.9,0.5)
b(40,36,100,3,66,48,90,3,0.5,0.5,0.5,0)
"""

INI = """; Created by: Jmol 14
Input_File_Name={name}.pov
Output_to_File=true
Output_File_Type={type}
Output_File_Name={name}.{ending}
Height=72
Width=96
{more}Antialias=true
Antialias_Threshold=0.1
Warning_Level=5
Verbose=false
"""


def render(kind, ending, more=""):
    """Creates an action that writes Jmol's two files and renders them as Jmol's dialogue does."""

    def action(box):
        name = box.folder / "caffeine"
        box.write("caffeine.pov", SCENE)
        ini = box.write("caffeine.pov.ini", INI.format(name=name, type=kind, ending=ending, more=more))
        result = box.run("povray", ini, cwd=box.root)
        box.record("failed", find_all(r"Parse Error|failed", result.stderr))

    return action


def line(box):
    """Renders with a line in Jmol's documentation, in the folder of the scene."""
    box.write("caffeine.pov", SCENE)
    box.run("povray", "+Icaffeine.pov", "+Ocaffeine.png", "+FN", "+W96", "+H72", "+A0.1", "-D")


CASES = [
    Case("png", render("N", "png", "Output_Alpha=true\nDisplay=true\nPause_When_Done=true\n")),
    Case("tga", render("C", "tga", "Preview_Start_Size=16\nPreview_End_Size=4\n")),
    Case("frames", render("P", "ppm", "Initial_Frame=1\nFinal_Frame=2\nInitial_Clock=1\nFinal_Clock=2\n")),
    Case("line", line),
]
