#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 1 }
sphere { <0,1,0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { emission .6 density { gradient x } density { spherical scale 2 } scale <.7,1,1> translate x*.2 } } rotate z*40 translate x*.5}
union { sphere { 0, .6 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { emission .5 density { radial color_map { [0 rgb 0] [1 rgb 1] } } } } }
 rotate 30 translate <-1.6,1,1> }
