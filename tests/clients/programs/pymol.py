"""PyMOL: `ray renderer=1` writes `tmp_pymol.pov`, runs one line of a shell, and loads `tmp_pymol.png` if it exists."""

from clients import Case, find_all

SCENE = """camera {orthographic location <0.0 , 0.0 , 50.0> look_at  <0.0 , 0.0 , -1.0> right -8.0*x up 6.0*y}
#default { texture { finish{phong 0.500 ambient 0.500 diffuse 0.450 phong_size 13.750}}}
light_source{<4000.0000,4000.0000,9948.0000>  rgb<1.0,1.0,1.0>}
plane{z , -60.0
pigment{color rgb<0.1000,0.1000,0.1000>}
finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
sphere{<-1.2000000,0.3000000,-5.0000000>, 1.4000
pigment{color rgb<0.2000,1.0000,0.2000>}}
cylinder{<-1.2000000,0.3000000,-5.0000000>,
<1.5000000,-0.5000000,-4.0000000>,
 0.2500
pigment{color rgb<0.2000,1.0000,0.2000>}}
smooth_triangle{<1.0,-1.5,-4.0>, <0.1,0.1,1.0>, <3.0,-1.0,-4.5>, <-0.1,0.1,1.0>, <2.0,1.6,-4.0>, <0.0,-0.2,1.0>
texture{pigment{color rgbt<0.9,0.5,0.1,0.2>}}}
"""


def render(options):
    """Creates an action that runs PyMOL's line; PyMOL reads back whether the picture exists."""

    def action(box):
        box.write("tmp_pymol.pov", SCENE)
        box.shell(f"povray +FN -D +Itmp_pymol.pov +Otmp_pymol.png +W80 +H60 {options}")

    return action


# Module of PyMOL in Debian's Python, which the command `pymol` does not find if another Python is the first in `PATH`.
MODULE = "/usr/lib/python3/dist-packages/pymol/povray.py"


def real(box):
    """Lets PyMOL write the scene, render the scene, and save the picture that PyMOL has loaded."""
    box.write("water.xyz", "3\nwater\nO 0 0 0.117\nH 0 0.757 -0.47\nH 0 -0.757 -0.47\n")
    commands = "load water.xyz; show spheres; bg_color white; ray 96, 72, renderer=1; png out.png"
    result = box.run("/usr/bin/python3", "-m", "pymol.__init__", "-cq", "-d", commands)
    box.record("loaded", find_all("loaded image from .*", result.stdout))


CASES = [
    Case("real", real, needs=(MODULE,)),
    Case("antialias", render("+A")),
    Case("plain", render("")),
]
