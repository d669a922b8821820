#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
#default { finish { ambient 1 diffuse 0 } }
// Scaled, a smooth triangle's normals may come to lie on both sides of it: then it is left out.
#macro S(Scale) smooth_triangle { <-0.758, 0.848, -0.947>, <0, .3, -1>, <0.894, -0.976, -0.888>, <.3, 0, -1>, <-0.799, 0.501, -0.333>, <-.3, 0, -1> scale Scale } #end
object { S(1) scale 1.5 translate <-1.5, 0, 0> pigment { rgb <.9, .3, .2> } }
object { S(<1, 1, 2>) scale 1.5 translate <1.5, 0, 0> pigment { rgb <.2, .9, .3> } }
union { object { S(1) } pigment { rgb <.2, .3, .9> } scale <1, 1, 2> translate <.2, .6, 0> }
