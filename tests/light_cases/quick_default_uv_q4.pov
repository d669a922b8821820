#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
light_source { <2, 4, -6> 1 }
#default { pigment { uv_mapping rgb .5 quick_color rgb <.2, .4, .9> } }
sphere { -x, 1 pigment { rgb <.9, .3, .1> } }
sphere { x, 1 }
plane { -z, -2 texture { gradient x texture_map { [0 pigment { rgb <.1, .8, .3> }] [1 pigment { rgb .7 quick_color rgb <.6, .1, .5> }] } scale 4 translate 20*x } }
