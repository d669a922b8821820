#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 2 spotlight point_at <0,1,0> radius 8 falloff 12 }
box { <-9,0,4>, <9,9,5> pigment { rgb .6 } }
media { samples 4 scattering { 1, .1 } absorption .02 }
sphere { <0,.5,0>, .5 pigment { rgb <.8,.2,.1> } }
