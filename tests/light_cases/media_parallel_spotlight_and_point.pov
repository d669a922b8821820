#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 1 parallel spotlight point_at <0,1,0> radius 4 falloff 6 }
light_source { <-3,6,-4> rgb <0,.2,.4> }
sphere { <0,1,0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { scattering { 1, .6 } } } }
