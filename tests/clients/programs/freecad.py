"""FreeCAD: the workbench Raytracing runs `povray` on a scene in the folder for temporary files and opens the picture; the workbench
Render runs one line of a shell with quotes around names.
"""

from clients import Case

SCENE = """#version 3.6;
#include "colors.inc"
#include "metals.inc"
global_settings {
    assumed_gamma 1.0
    ambient_light color rgb <1.0,1.0,1.0>
    max_trace_level 20
}
#declare cam_location =  <12.5,9.5,-14.5>;
#declare cam_look_at  = <0,1,0>;
#declare cam_sky      = <-0.3,0.9,0.3>;
#declare cam_angle    = 45;
camera {
  location  cam_location
  look_at   cam_look_at
  sky       cam_sky
  angle     cam_angle
  right x*96/72
}
sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.0 rgb <0.6,0.7,1.0>]
      [0.7 rgb <0.0,0.1,0.8>]
    }
  }
}
plane {
  y, -1
  texture { pigment {rgb <0.0,0.0,0.0>} finish {ambient 0.0 reflection 0.05 specular 0.0} }
}
#declare StdFinish = finish { ambient 0.01 diffuse 0.9 phong 1.0 phong_size 70 metallic brilliance 1.5} ;
// Facets of a pyramid
#declare Box = mesh2 { vertex_vectors { 5, <-3,0,-3>,<3,0,-3>,<3,0,3>,<-3,0,3>,<0,5,0> }
  face_indices { 6, <0,1,4>,<1,2,4>,<2,3,4>,<3,0,4>,<0,1,2>,<0,2,3> } }
object { Box texture { pigment { color rgb <0.8,0.8,0.8> } finish { StdFinish } } }
light_source { cam_location + cam_angle * 100 color rgb <10, 10, 10> }
"""


def raytracing(box):
    """Runs the words of the workbench Raytracing, with its default parameters `+P +A`."""
    scene = box.temporary / "FreeCAD_Doc_Render.pov"
    scene.write_text(SCENE)
    box.run("povray", "+P", "+A", "+W96", "+H72", f"+O{box.folder}/Povray.png", scene)


def render(box):
    """Runs the line of the workbench Render."""
    scene = box.temporary / "project.pov"
    scene.write_text(SCENE)
    box.shell(f'povray -D +A0.3 +W96 +H72 +O"{box.folder}/project.png" "{scene}"')


CASES = [Case("raytracing", raytracing), Case("render", render)]
