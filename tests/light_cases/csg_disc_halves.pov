#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at 0 angle 30 } light_source { <5,8,-6> rgb 1 } light_source { <-5,-8,-6> rgb .5 }
union {
  intersection { sphere { 0,1 } disc { 0,<1,-2,.5>,1.1 } translate -1.2*x }
  pigment { rgb <1,.5,.4> }
}
intersection { sphere { <0,-.5,0>,1 } disc { 0,-y,1.1 } rotate 20 translate 1.2*x pigment { rgb <.5,.7,1> } }
intersection { sphere { <0,-.5,0>,.8 } disc { 0,-y,1.1 rotate 10*x } translate .8*y pigment { rgb 1 } }
