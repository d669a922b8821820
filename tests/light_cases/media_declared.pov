#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
#declare D = density { spherical translate y }
#declare M = media { emission <.5,.3,.2> density { D } }
#declare I = interior { media { M absorption .4 } }
light_source { <3,6,-4> rgb 1 }
sphere { <0,1,0>, 1 pigment { rgbt 1 } hollow interior { I } }
sphere { <2,1,1>, 1 pigment { rgbt 1 } hollow interior { I media { M emission <0,.3,0> scale 2 } } }
