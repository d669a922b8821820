#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 }
light_source { <2, 4, -6> 1 }
plane { y, -1e5 pigment { rgb <.2, .7, .1> } }
rainbow { direction <.1, .2, 2> angle 17 width 24 color_map { [0 rgb <.9, .1, .2>] [1 rgb <.1, .3, .8>] } }
