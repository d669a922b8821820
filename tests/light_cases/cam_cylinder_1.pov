#version 3.7; global_settings { assumed_gamma 1 }
#declare T = texture { pigment { rgb <.8,.6,.3> } finish { ambient .1 diffuse .7 specular .3 reflection .2 } }
light_source { <5,8,-6> rgb 1 } sphere { <0,1,0>,1 texture { T } } plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { reflection .15 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9,.8,.7>][.6 rgb <.2,.3,.8>] } } } box { <-3,0,2>,<-2,3,3> pigment { rgb x } } cone { <3,0,1>,1,<3,2,1>,0 pigment { rgb y } }
camera { cylinder 1 location <1,2,-6> look_at <0,.5,0> angle 100 }
