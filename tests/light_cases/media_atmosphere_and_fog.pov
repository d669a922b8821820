#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 1 }
box { <-9,0,4>, <9,9,5> pigment { rgb .6 } }
media { emission .02 absorption .05 }
fog { distance 20 rgb <.2,.3,.5> }
sphere { <0,1,0>, 1 hollow pigment { rgbt <1,1,1,.7> } interior { media { absorption .4 } } }
