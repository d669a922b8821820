// Spheres and triangles farther away than 1e7 are not hit, nor do they cast shadows; boxes are.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
#declare Glow = texture { pigment { rgb <1, 0.4, 0.2> } finish { ambient 1 diffuse 0 } }
sphere { <-5e6, 0, 2e7>, 3e6 texture { Glow } }
triangle { <1e6, -4e6, 2e7>, <4e6, -4e6, 2e7>, <2e6, -1e6, 2e7> texture { Glow } }
box { <4e6, -2e6, 1.9e7>, <6e6, 0, 2e7> texture { Glow } }
