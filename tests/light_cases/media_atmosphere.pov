#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 1 media_attenuation on }
box { <-9,0,4>, <9,9,5> pigment { rgb .6 } }
media { method 2 samples 6 scattering { 1, .04 } absorption .02 }
sphere { <0,1,0>, 1 pigment { rgb <.8,.2,.1> } }
