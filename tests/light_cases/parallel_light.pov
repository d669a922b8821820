#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.5,0> }
#declare T = texture { pigment { rgb <.8,.6,.3> } finish { ambient .1 diffuse .7 specular .3 reflection .2 } }
#declare F = plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { reflection .15 } }
light_source { <3,6,-4> rgb 1 parallel point_at <0,.5,0> fade_distance 6 fade_power 1 } sphere { <0,1,0>,1 texture { T } } F
