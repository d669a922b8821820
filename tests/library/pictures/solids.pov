// The polyhedra of shapes2.inc, the declared shapes of shapes.inc, faces of four corners.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "shapes.inc"
#include "shapes2.inc"

camera { location <0, 30, -95> look_at 0 right 10.6*x up 8*y direction 100*z }
light_source { <5, 9, -10>, White }
light_source { <-8, 3, -4>, Gray40 }
background { Gray30 }
#default { finish { ambient 0.2 diffuse 0.7 } }

#macro Stand(Object, Column, Row, Shown)
  object { Object scale 0.7 rotate <10, 25, 0> translate <-4.2 + 1.68*Column, 3 - 2*Row, 0> pigment { Shown } }
#end
Stand(object { Tetrahedron scale 0.7 }, 0, 0, Red)
Stand(Octahedron, 1, 0, Orange)
Stand(Dodecahedron, 2, 0, Yellow)
Stand(Icosahedron, 3, 0, Green)
Stand(object { Rhomboid scale 0.8 }, 4, 0, Cyan)
Stand(Hexagon, 5, 0, SlateBlue)
Stand(HalfCone_Y, 0, 1, Violet)
Stand(Pyramid, 1, 1, Pink)
// POV-Ray does not see it elsewhere, because its bounding box is not where it is.
Stand(intersection { object { Pyramid2 } box { <-0.9, 0.01, -0.9>, <0.9, 0.9, 0.9> } }, 2, 1, Tan)
Stand(Square_X, 3, 1, NeonBlue)
Stand(Square_Y, 4, 1, Silver)
Stand(Square_Z, 5, 1, Brass)
Stand(Cone_X, 0, 2, MidnightBlue)
Stand(Cone_Y, 1, 2, HuntersGreen)
Stand(Cone_Z, 2, 2, Maroon)
Stand(object { UnitBox scale 0.7 }, 3, 2, Quartz)
Stand(intersection { object { Sphere } object { Plane_XZ } object { Plane_XY inverse } }, 4, 2, Thistle)
Stand(object { Ellipsoid scale <1, 0.6, 0.8> }, 5, 2, Khaki)
Stand(object { Disk_X scale <0.8, 0.6, 0.6> }, 0, 3, CadetBlue)
Stand(object { Disk_Y scale <0.8, 0.6, 0.6> }, 1, 3, Sienna)
Stand(object { Disk_Z scale <0.8, 0.6, 0.6> }, 2, 3, Feldspar)
Stand(union { Quad(<-1, -1, 0>, <0.6, -1, 0.3>, <1, 1, 0>, <-0.4, 0.7, 0.6>) }, 3, 3, SeaGreen)
Stand(
  union { Smooth_Quad(<-1, -1, 0>, <-1, -1, -1>, <1, -1, 0>, <1, -1, -1>, <1, 1, 0>, <1, 1, -1>, <-1, 1, 0>, <-1, 1, -1>) },
  4, 3, SpringGreen
)
Stand(intersection { object { Cube } object { Plane_YZ rotate 45*z } }, 5, 3, Wheat)
