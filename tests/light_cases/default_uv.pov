#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
#default { pigment { uv_mapping gradient x scale .3 rotate z*20 } normal { uv_mapping bumps 1 scale .2 } }
box { -1, 0 pigment { boxed } rotate 20*y }
box { <.2,-1,-1>, <1.2,0,0> pigment { gradient y color_map { [0 rgb x] [1 rgb y] } } normal { gradient x 1 scale .3 } }
box { <-1,.2,-1>, <0,1.2,0> pigment { color_map { [0 rgb x] [1 rgb y] } } normal { bump_size 3 } }
box { <.2,.2,-1>, <1.2,1.2,0> pigment { checker } }
