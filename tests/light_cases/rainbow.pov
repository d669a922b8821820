#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.5,0> }
#declare T = texture { pigment { rgb <.8,.6,.3> } finish { ambient .1 diffuse .7 specular .3 reflection .2 } }
#declare F = plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { reflection .15 } }
rainbow { direction <.2,-.1,1> angle 15 width 8 distance 20 color_map { [0 rgbft <1,0,0,.2,.5>][.5 rgbt <0,1,0,.3>][1 rgbt <0,0,1,.9>] } arc_angle 180 falloff_angle 90 } fog { distance 40 rgb .7 } sky_sphere { pigment { rgb <.4,.5,.9> } } light_source { <5,8,-6> rgb 1 } sphere { <0,1,0>,1 texture { T } } F
