// `slope` and `aoi` see bumps: after `no_bump_scale` as long as they are, in the entry of a map as they are in its space.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 50 }
light_source { <-4, 5, -7> rgb 1 }
#declare Map = color_map { [0 rgb <1, 0.2, 0.1>] [0.5 rgb <0, 1, 0.3>] [1 rgb <0.2, 0.4, 1>] }
#declare Slope = pigment { slope <0.1, 0.1, -2> color_map { Map } }
#declare Aoi = pigment { aoi color_map { Map } }
#declare Glow = finish { ambient 1 diffuse 0 }
#macro At(X, Y) scale 0.65 translate <X, Y, 0> #end
sphere { 0, 1 texture { pigment { slope y color_map { Map } } normal { bumps 0.2 scale 0.3 no_bump_scale } finish { Glow } scale <1, 2, 0.5> } At(-2.2, 1) }
sphere { 0, 1 pigment { slope y color_map { Map } } normal { gradient x normal_map { [0 bumps 0.3 scale 0.3] [1 wrinkles 0.4] } no_bump_scale } finish { Glow } At(-0.75, 1) }
sphere { 0, 1 texture { gradient x texture_map { [0 pigment { Slope } normal { wrinkles 0.2 scale 0.4 } finish { Glow }] [1 pigment { rgb 1 }] } rotate 40 } At(0.75, 1) }
sphere { 0, 1 texture { checker texture { pigment { Aoi } normal { wrinkles 0.2 } finish { Glow } } texture { pigment { slope x color_map { Map } } normal { bumps 0.3 scale 0.3 no_bump_scale } } scale <1, 2, 0.5> } At(2.2, 1) }
sphere { 0, 1 texture { gradient x texture_map { [0 pigment { Aoi } normal { wrinkles 0.2 scale 0.4 } finish { Glow } rotate 30] [1 pigment { rgb 1 }] } } scale <1, 1.3, 0.6> rotate 20 At(-2.2, -1) }
sphere { 0, 1 texture { gradient x texture_map { [0 pigment { rgb 1 } normal { wrinkles 0.2 scale 0.4 no_bump_scale }] [1 pigment { Slope }] } scale 2 } At(-0.75, -1) }
sphere { 0, 1 texture { average texture_map { [1 pigment { rgb 1 } normal { wrinkles 0.2 scale 0.4 no_bump_scale }] [1 pigment { Aoi } normal { dents 0.3 }] } scale <1, 2, 0.5> rotate 30 } At(0.75, -1) }
sphere { 0, 1 pigment { Slope } finish { Glow } At(2.2, -1) }
