#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
sphere { <-1.5,.3,0>, .8 pigment { slope x color_map { [0 rgb 0] [1 rgbt 1] } } }
sphere { <.3,.3,0>, .8 pigment { aoi color_map { [.4 rgb 0] [1 rgbt 1] } } }
sphere { <1.8,.3,0>, .6 texture { slope y texture_map { [.3 pigment { rgb x }] [.6 pigment { rgbt 1 }] } } }
