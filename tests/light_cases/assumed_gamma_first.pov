// Of several `assumed_gamma` the first counts, in one block or in two.
#version 3.6;
global_settings { assumed_gamma 1.4 assumed_gamma 2.2 }
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 40 }
light_source { <-4, 5, -7> rgb 1 }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
sphere { 0, 1.2 pigment { rgb <0.9, 0.4, 0.1> } finish { phong 0.5 } }
