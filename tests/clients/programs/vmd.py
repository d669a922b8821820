"""VMD: the renderer "POV3" runs one line in the user's folder, by default `povray +W%w +H%h -I%s -O%s.tga +D +X +A +FT`."""

from clients import Case

SCENE = """// POV 3.x input script : vmdscene.pov
// try povray +W96 +H72 -Ivmdscene.pov -Ovmdscene.pov.tga +P +X +A +FT +C
#if (version < 3.5)
#error "VMD POV3DisplayDevice has been compiled for POV-Ray 3.5 or above."
#end
#declare VMD_line_width=0.0020;
#macro VMDC ( C1 )
  texture { pigment { rgbt C1 }}
#end
#macro VMD_sphere (P1, R1, C1)
  sphere {P1, R1 texture {C1} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end #if (shadow) no_shadow #end}
#end
#declare shadow = false;
#declare VMD_clip_on=array[3] {0, 0, 0};
#declare VMD_clip=array[3];
#declare VMD_scaledclip=array[3];
#declare VMD_line_width=0.0020;
#macro VMD_cylinder (P1, P2, R1, C1, O1)
  cylinder {P1, P2, R1 #if (O1) open #end texture {C1}}
#end
camera {
  orthographic
  location <0.0000, 0.0000, -2.0000>
  look_at <-0.0000, -0.0000, 2.0000>
  up <0.0000, 3.0000, 0.0000>
  right <4.0000, 0.0000, 0.0000>
}
light_source {
  <-0.1000, 0.1000, -1.0000>
  color rgb<1.000, 1.000, 1.000>
  parallel
  point_at <0.0, 0.0, 0.0>
}
background {
  color rgb<0.000, 0.000, 0.000>
}
#default { texture {
 finish { ambient 0.000 diffuse 0.650 phong 0.1 phong_size 40.000 specular 0.500 }
} }
#declare VMD_clip_on[1]=0;
sphere { <-0.6, 0.2, 0>, 0.55 texture { pigment { rgbt <0.25, 0.25, 0.75, 0> } } }
VMD_sphere (<0.7, -0.2, 0.1>, 0.45, pigment { rgbt <1, 0, 0, 0.3> })
VMD_cylinder (<-0.6, 0.2, 0>, <0.7, -0.2, 0.1>, 0.1, pigment { rgb <0.3, 0.8, 0.3> }, 1)
// End of POV-Ray 3.x generation
"""


def render(line):
    """Creates an action that runs a line with the name of the scene in it."""

    def action(box):
        box.write("vmdscene.pov", SCENE)
        box.shell(line)

    return action


CASES = [
    Case("default", render("povray +W96 +H72 -Ivmdscene.pov -Ovmdscene.pov.tga +D +X +A +FT")),
    Case("continue", render("povray +W96 +H72 -Ivmdscene.pov -Ovmdscene.pov.tga +P +X +A +FT +C")),
]
