#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
#default { pigment { image_map { function 6, 6 { x*0.7 + y*0.2 } } } }
box { -1, 0 pigment { crackle scale .3 } rotate 20*y }
box { <.2,-1,-1>, <1.2,0,0> pigment { agate } }
box { <-1,.2,-1>, <0,1.2,0> pigment { gradient x pigment_map { [0 rgb x] [1 bozo scale .2] } } }
box { <.2,.2,-1>, <1.2,1.2,0> }
