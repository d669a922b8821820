#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
sphere { <-1.5,0,0>, .8 texture { pigment { rgbt <0,1,0,.3> } } texture { pigment { rgb x } } }
sphere { <0,0,0>, .7 texture { pigment { rgbt <0,1,0,.3> } } texture { pigment { rgbf <1,0,0,.4> } } texture { pigment { rgbf <0,0,1,.4> } } }
sphere { <1.4,0,0>, .7 texture { pigment { rgb x } } texture { pigment { rgbt <0,0,1,.5> } } }
