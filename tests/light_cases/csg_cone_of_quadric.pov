#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at 0 angle 30 } light_source { <5,8,-6> rgb 1 } light_source { <-5,-8,-6> rgb .5 }
#declare Q = quadric { <1,-1,1>,0,0,0 }
intersection { plane { y,1 } object { Q } object { Q scale <.7,1,.7> inverse } plane { -y,1.1 } rotate 20*z pigment { rgb 1 } }
intersection { box { -1,1 } object { Q } scale .4 translate <1.2,.6,-2> pigment { rgb x } }
