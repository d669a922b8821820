#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
#declare Red = texture { pigment { gradient x color_map { [0 rgb <1,.2,.1>] [1 rgb <.2,.9,.1>] } scale .3 } } #declare Glass = texture { pigment { rgbft <.3,.4,1,.3,.4> } } #declare M = material { texture { Glass } }
#declare B = box { -1, <-.05,1,1> texture { Red } }
object { B texture { Glass } rotate 30*y translate -x*1.2 }
sphere { <1.2,0,0>, .9 pigment { rgb x } material { M texture { pigment { rgbt <0,1,0,.8> } } } }
