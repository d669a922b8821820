#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.5,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } }
light_source { <3,6,-4> rgb 1 } sphere { <0,1,0>,1 pigment { rgb .5 transmit -.4 } finish { ambient 1 } no_shadow } sphere { <2,1,-1>,.6 pigment { rgb <.5,.9,.4> filter -.6 } finish { ambient .7 } no_shadow }
