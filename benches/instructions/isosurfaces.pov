// Isosurfaces: over a pigment, of powers and logarithms, and of noise.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 45 }
light_source { <5, 8, -6> rgb 1 }
#include "functions.inc"
#declare Height = function { pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } scale 0.3 } }
#default { pigment { rgb <0.6, 0.7, 0.4> } }
#for (I, -1, 1)
  isosurface { function { y + 0.4 * Height(x, 0, z).gray } contained_by { box { -0.5, 0.5 } } max_gradient 3 translate <1.3 * I, -0.8, 0> }
#end
isosurface { function { pow(abs(x), 1.5) + pow(abs(y), 1.5) + z * z + 0.2 * log(1 + x * x) - 0.6 } contained_by { box { -1, 1 } } max_gradient 4 translate <-1, 0.8, 0> }
isosurface { function { sqrt(x * x + y * y + z * z) - 0.8 + 0.2 * f_noise3d(5 * x, 5 * y, 5 * z) } contained_by { sphere { 0, 1 } } max_gradient 3 translate <1.2, 0.8, 0> }
