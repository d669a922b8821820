// One thing with three arms, moved by each transformation of transforms.inc; what math.inc and shapes.inc say of it.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "consts.inc"
#include "shapes.inc"
#include "transforms.inc"

camera { location <0, 5, -12> look_at <0, 0, 0> angle 44 right 4/3*x }
light_source { <5, 9, -8>, White }
light_source { <-8, 3, -4>, Gray40 }
#default { finish { ambient 0.2 diffuse 0.6 } }
plane { y, -3 pigment { checker Gray30, Gray35 } }

#declare Thing = union {
  box { -0.2, <1, 0.2, 0.2> pigment { Red } }
  cone { o, 0.2, y, 0.1 pigment { Green } }
  cylinder { o, z, 0.2 pigment { Blue } }
}
object { Thing Shear_Trans(x, y + 0.5*x, z + 0.3*y) translate <-4, 2.5, 0> }
object { Thing Matrix_Trans(x + 0.4*z, y, z - 0.3*x, <-1.6, 2.5, 0>) }
object { Thing Axial_Scale_Trans(<1, 1, 0>, 1.7) translate <0.8, 2.2, 0> }
object { Thing Axis_Rotate_Trans(<1, 2, 1>, 70) translate <3.6, 2.5, 0> }
object { Thing translate <-4, 0.2, 0> Rotate_Around_Trans(<20, 50, 30>, <-3.4, 0.2, 0>) }
object { Thing Reorient_Trans(x, <1, 1, -1>) translate <-1.4, 0, 0> }
object { Thing Point_At_Trans(<1, 1, -0.5>) translate <1, 0, 0> }
object { Center_Object(Thing, xy) translate <3.6, 0.4, 0> }
object { Align_Object(Thing, <-1, 1, 0>, <-4.6, -1, -1>) }
#declare Way = spline { natural_spline -1, <-3, -2, -2> 0, <-2, -2, -2.5> 1, <0, -2, -1> 2, <2, -2, -2> 3, <4, -1, -1> 4, <5, 0, 0> }
#for (I, 0, 5)
  object { Thing scale 0.5 Spline_Trans(Way, I/2, y, 0.01, 0) }
#end
// A cross where its box is, seen through vtransform and back.
#declare Shift = transform { rotate 20*z translate <0.4, 1.6, -1> }
#for (I, 0, 5)
  sphere { vtransform(VRotation(x, <1, 1, 0>, z)*<I, 0, 0>, Shift), 0.15 pigment { Gold } }
  sphere { vinv_transform(VPerp_Adjust(<I, 1, 2>, y)*3, Shift), 0.12 pigment { Magenta } }
#end
#declare Point = o;
#declare Normal = o;
#for (I, 0, 4)
  #if (IsectN(<-0.45 + 0.3*I, 0.1, -5>, z, Thing, Point, Normal))
    cone { Point, 0.08, Point + 0.5*Normal, 0 translate <2.6, -1.6, -3> pigment { White } }
  #end
#end
