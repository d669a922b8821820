#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.5,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } }
fog { distance 12 rgb <.5,.6,.7> filter .3 transmit .1 } light_source { <3,6,-4> rgb 6 media_attenuation on } sphere { <0,1,0>,1 pigment { rgbt .8 } } sphere { <2,1,0>,1 hollow pigment { rgbt .8 } }
