#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.5,0> }
#declare T = texture { pigment { rgb <.8,.6,.3> } finish { ambient .1 diffuse .7 specular .3 reflection .2 } }
#declare F = plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { reflection .15 } }
#version 3.5; sky_sphere { pigment { gradient y color_map { [0 rgb <.9,.8,.7>][.6 rgb <.2,.3,.8>] } } pigment { bozo turbulence .6 scale .2 color_map { [.4 rgbf <.4,.5,.6,.7>][.8 rgbft <1,.2,1,.2,.3>] } } rotate 20*z }
light_source { <5,8,-6> rgb 1 } sphere { <0,1,0>,1 texture { T } } F
