#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb <1,.5,.5> media_attenuation on media_interaction off }
light_source { <-3,6,-4> rgb <0,.5,.5> media_attenuation on }
fog { distance 9 rgb <0,0,.2> }
media { absorption .05 }
sphere { <0,1,0>, 1 pigment { rgb 1 } }
