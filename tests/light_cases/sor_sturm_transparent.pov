// A transparent `sor` with `sturm`.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
sor { 7, <0.2, -1.4> <0.6, -1> <0.9, -0.5> <0.5, 0> <0.7, 0.5> <0.3, 1> <0.1, 1.4> sturm pigment { rgbt <1, 0.5, 0.2, 0.7> } rotate <30, 0, 70> }
