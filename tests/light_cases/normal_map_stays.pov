// A map of the default or declared normal stays when another pattern is named, but not before a pattern of cells.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 50 }
light_source { <-4, 5, -7> rgb 1 }
#declare Mapped = normal { gradient x normal_map { [0 bumps 0.4 scale 0.4] [1 wrinkles 1 scale 0.3] } }
#declare Sloped = normal { gradient x 0.6 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -2>] } }
#declare Listed = normal { checker normal { bumps 0.5 scale 0.4 } normal { wrinkles 1 scale 0.3 } }
#macro At(X, Y) scale 0.65 translate <X, Y, 0> #end
sphere { 0, 1 pigment { rgb 1 } normal { Mapped spherical 0.3 } At(-2.2, 1) }
sphere { 0, 1 pigment { rgb 1 } normal { Mapped leopard 0.3 scale 0.2 } At(-0.75, 1) }
sphere { 0, 1 pigment { rgb 1 } normal { Mapped checker 0.3 scale 0.41 } At(0.75, 1) }
sphere { 0, 1 pigment { rgb 1 } normal { Sloped gradient y 0.5 scale 0.7 } At(2.2, 1) }
sphere { 0, 1 pigment { rgb 1 } normal { Listed leopard 0.5 scale 0.4 } At(-2.2, -1) }
sphere { 0, 1 pigment { rgb 1 } normal { Listed checker 0.5 scale 0.41 } At(-0.75, -1) }
#default { texture { normal { Mapped } } }
sphere { 0, 1 pigment { rgb 1 } normal { wrinkles 1 scale 0.4 } At(0.75, -1) }
sphere { 0, 1 pigment { rgb 1 } normal { Sloped wood 0.5 } At(2.2, -1) }
