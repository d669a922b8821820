#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye angle 150 location <.5, 2.3, -6> look_at 0 normal { bumps .2 scale .5 } }
light_source { <2, 4, -6> 1 }
plane { y, -1 pigment { gradient x scale 40 translate -20*x } }
sky_sphere { pigment { gradient y color_map { [0 rgb z] [1 rgb x] } scale 2 translate y } }
