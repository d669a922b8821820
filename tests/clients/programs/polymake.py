"""polymake: `povray(cube(3)->VISUAL)` runs a viewer; the viewer "povray" runs its line in the user's folder, on a scene whose first
`#include` is an absolute path below /usr/share/polymake. The name of the picture ends with `.tga`, although no option asks for that
type.
"""

from pathlib import Path

from clients import Case, find_all

RESOURCES = Path("/usr/share/polymake/resources/povray")

# What polymake's scene needs of its resources, written by this script for machines without polymake.
STAND_IN = """#include "colors.inc"
#include "textures.inc"
global_settings { assumed_gamma 1.0 }
camera { location <1.5, 2, -4> look_at <0, 0, 0> right x*image_width/image_height angle 40 }
light_source { <10, 20, -30> color White }
background { color White }
#default { finish { ambient 0.3 diffuse 0.7 } }
#declare T_Polytope_nodes = texture { pigment { color Red } finish { phong 0.6 } }
#declare T_Polytope_wires = texture { pigment { color Black } }
#declare T_Polytope_faces = texture { pigment { color rgbt <0.3, 0.6, 0.4, 0.2> } }
"""

SCENE = """/*
  This povray file was created using polymake.
*/
#include "{include}"

#declare MIN_EXTENT = <-1,-1,-1>;
#declare MAX_EXTENT = <1,1,1>;
#declare ORIGIN     = MIN_EXTENT + (MAX_EXTENT-MIN_EXTENT)/2;
#declare SCALE      = 1/vlength((MAX_EXTENT-MIN_EXTENT)/2);

// p ---BEGIN
#declare vertex_list_p = array[6] {
<1,0,0>,
<-1,0,0>,
<0,1,0>,
<0,-1,0>,
<0,0,1>,
<0,0,-1>}

#declare vertices_of_p = object {
  #local pth = 0.06/SCALE;
  union {
    sphere { vertex_list_p[0], pth }
    sphere { vertex_list_p[2], pth }
    sphere { vertex_list_p[5], pth }
  }
  texture { T_Polytope_nodes pigment { color rgb <0.47,0.56,0.16> } }
}
object {
  vertices_of_p
  translate -ORIGIN
  scale SCALE
}
object {
  union {
    polygon { 4, vertex_list_p[0], vertex_list_p[2], vertex_list_p[5], vertex_list_p[0] }
    polygon { 4, vertex_list_p[1], vertex_list_p[2], vertex_list_p[5], vertex_list_p[1] }
  }
  pigment { color rgb <0.3,0.7,0.5> }
  translate -ORIGIN
  scale SCALE
}
// p ---END
"""


def render(box, include):
    """Renders the scene twice: polymake numbers the second picture."""
    scene = box.temporary / "poly1.pov"
    scene.write_text(SCENE.replace("{include}", str(include)))
    for name in ("octahedron.tga", "octahedron_1.tga"):
        line = f"povray +P -V +D +A0.5 +W80 +H60 +O{name} {scene}; echo CREATED {name}"
        box.record("created", box.shell(line).stdout)


def stand_in(box):
    """Renders a scene with an absolute include of the box."""
    include = box.root / "share/povray/polymake-scene.pov"
    include.parent.mkdir(parents=True)
    include.write_text(STAND_IN)
    render(box, include)


def real(box):
    """Lets polymake write the scene and run the viewer."""
    script = 'use application "polytope"; povray(cross(3)->VISUAL(Title => "octahedron", VertexLabels => "hidden"));'
    box.record("created", find_all("^CREATED .*", box.run("polymake", script).stdout))


CASES = [
    Case("real", real, needs=("polymake",)),
    Case("absolute-include", stand_in),
    Case("resources", lambda box: render(box, RESOURCES / "polymake-scene.pov"), needs=(str(RESOURCES / "polymake-scene.pov"),)),
]
