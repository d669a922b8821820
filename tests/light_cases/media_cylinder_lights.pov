#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <0,6,-1> rgb 2 cylinder point_at <0,0,0> radius .3 falloff .5 }
light_source { <3,3,-3> rgb <0,1,1> cylinder point_at <0,1,0> radius .2 falloff .4 }
sphere { <0,1,0>, 1.3 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { method 2 samples 2 intervals 8 scattering { 1, .6 } } } }
