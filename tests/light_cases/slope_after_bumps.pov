// `slope` and `aoi` of a texture without bumps see those of the texture before it: the layer above, the later entry of a map, the earlier
// one of an average.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 50 }
light_source { <-4, 5, -7> rgb 1 }
#declare Map = color_map { [0 rgb <1, 0.2, 0.1>] [0.5 rgb <0, 1, 0.3>] [1 rgb <0.2, 0.4, 1>] }
#declare Thin = color_map { [0 rgbt <1, 0.2, 0.1, 0.3>] [0.5 rgbt <0, 1, 0.3, 0.6>] [1 rgbt <0.2, 0.4, 1, 0.5>] }
#declare Glow = finish { ambient 1 diffuse 0 }
#declare Plain = texture { pigment { aoi color_map { Map } } finish { Glow } }
#declare Bumpy = texture { pigment { slope y color_map { Map } } normal { wrinkles 0.6 scale 0.5 } finish { Glow } }
#macro At(X, Y) scale 0.65 translate <X, Y, 0> #end
sphere { 0, 1 texture { gradient x texture_map { [0 Plain] [1 Bumpy] } } At(-2.2, 1) }
sphere { 0, 1 texture { gradient x texture_map { [0 Bumpy] [1 Plain] } } At(-0.75, 1) }
sphere { 0, 1 texture { average texture_map { [1 Bumpy] [1 Plain] } rotate 40 } At(0.75, 1) }
sphere { 0, 1 texture { average texture_map { [1 Plain] [1 Bumpy] [1 Plain] } } At(2.2, 1) }
sphere { 0, 1 texture { Plain } texture { pigment { slope y color_map { Thin } } normal { dents 0.6 scale 0.5 } finish { Glow } } At(-2.2, -1) }
sphere { 0, 1 texture { Bumpy } texture { pigment { slope y color_map { Thin } } finish { Glow } } At(-0.75, -1) }
sphere { 0, 1 texture { gradient x texture_map { [0 Plain] [1 bozo texture_map { [0 Plain] [1 Bumpy] } scale 0.3 rotate 30] } rotate 50 } At(0.75, -1) }
sphere { 0, 1 texture { gradient x texture_map { [0 gradient y texture_map { [0 Plain] [1 Bumpy] } rotate 30] [1 Plain] } rotate 50 } At(2.2, -1) }
