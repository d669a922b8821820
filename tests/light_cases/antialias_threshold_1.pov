// options: Antialias=on Antialias_Threshold=3.0 +AM1 +R2
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
plane { z, 0 pigment { checker rgb 0 rgb <1, .6, .3> scale <.37, .41, 1> } finish { ambient 0 diffuse 0 emission 1 } }
sphere { 0, .9 pigment { gradient x color_map { [0 rgb .2] [1 rgb .9] } scale 2 translate x } finish { ambient 0 diffuse 0 emission 1 } }
