#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 100 recursion_limit 3 error_bound 0.7 } }
camera { location <0, 3, -9> right x*image_width/image_height look_at <0, 0.8, 0> angle 42 }
background { rgb <0.6, 0.7, 0.9> }
plane { y, 0 pigment { srgb 0.8 } }
sphere { y, 1 pigment { srgb 0.9 } }
box { <1.2, 0, -1>, <1.4, 2.4, 2> pigment { srgb <0.9, 0.2, 0.1> } }
