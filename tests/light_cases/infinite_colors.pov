// A colour's infinite component is white, one that is no number is black.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 40 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
sphere { -0.8*x, 0.9 pigment { rgb <1/0, 0.4, 0.1> } finish { ambient 0 diffuse 0.7 } }
sphere { 1.1*x, 0.8 pigment { rgb <0.2, 0.5, 1/0> } finish { ambient 0.3 diffuse 0 } }
