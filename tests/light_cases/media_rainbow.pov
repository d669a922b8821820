#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 1 }
rainbow { direction <-.1,-.3,1> angle 20 width 30 distance 9 color_map { [0 rgbt <1,.2,0,.4>] [1 rgbt <0,.2,1,.4>] } }
media { absorption .08 emission <0,.03,.02> }
sphere { <0,1,20>, 22 hollow pigment { rgb .3 } }
