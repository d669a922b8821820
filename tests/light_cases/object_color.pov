// A colour in an object itself has no effect.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 40 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
sphere { -0.8*x, 0.9 color rgb <1, 0, 0> finish { ambient 0.3 } }
sphere { 1.1*x, 0.8 pigment { rgb <0.2, 0.7, 0.9> } color rgb <1, 0, 0> }
