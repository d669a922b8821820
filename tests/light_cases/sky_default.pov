#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, -3> look_at <0, 3, 1> }
light_source { <2, 4, -6> 1 }
#default { pigment { uv_mapping gradient x color_map { [0 rgb 1] [1 rgb .5] } scale .1 quick_color rgb x } }
sky_sphere { pigment { gradient y pigment_map { [0 rgb <.2, .4, .6>] [.5 gradient x] [1 rgb <.8, .1, .3>] } } pigment { color_map { [0 rgbt <1, 0, 0, .5>] [1 rgbt <0, 1, 0, .5>] } } }
plane { y, -1 }
