// The objects with round edges of shapes.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "shapes.inc"

camera { location <0, 4, -10> look_at <0, -0.2, 0> angle 46 right 4/3*x }
light_source { <5, 9, -8>, White }
light_source { <-8, 3, -4>, Gray40 }
#default { finish { ambient 0.15 diffuse 0.6 phong 0.3 } }

plane { y, -1.2 pigment { checker Gray70, Gray85 } }
object { Round_Box(<-1, -0.7, -0.6>, <1, 0.7, 0.6>, 0.3, yes) pigment { Firebrick } rotate 35*y translate <-2.8, -0.2, 1.5> }
object { Wire_Box(<-0.8, -0.8, -0.8>, <0.8, 0.8, 0.8>, 0.12, no) pigment { MediumForestGreen } rotate <20, 25, 0> translate <0, 0, 2> }
object { Round_Cylinder(<2.2, -1, 1.2>, <3.4, 0.9, 1.8>, 0.7, 0.2, yes) pigment { SteelBlue } }
object { Round_Cone(<-3.2, -1.2, -1.5>, 0.9, <-2.8, 0.3, -1.5>, 0.4, 0.15, no) pigment { Goldenrod } }
object { Round_Cone2(<-1.4, -0.7, -2>, 0.45, <-0.2, 0.2, -1.4>, 0.2, yes) pigment { Orchid } }
object { Round_Cone3(<0.8, -0.9, -2>, 0.5, <1.4, 0.4, -1.8>, 0.2, no) pigment { Turquoise } }
intersection {
  sphere { <0, 0, 0>, 0.8 }
  object { Wedge(240) }
  pigment { Coral }
  rotate 100*y
  translate <2.7, -0.4, -1.4>
}
object { Spheroid(<0, -0.9, 0>, <0.8, 0.3, 0.5>) pigment { Wheat } rotate 30*y }
merge {
  sphere { <-1.8, 1.2, 3>, 0.5 }
  sphere { <1.6, 1.9, 3>, 0.2 }
  object { Connect_Spheres(<-1.8, 1.2, 3>, 0.5, <1.6, 1.9, 3>, 0.2) }
  pigment { Salmon }
}
