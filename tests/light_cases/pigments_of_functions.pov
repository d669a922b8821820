// Pigments of functions and of `pigment_pattern` do not begin with the default one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 50 }
light_source { <-4, 5, -7> rgb 1 }
#default { texture { pigment { gradient x color_map { [0 rgb <1, 0.2, 0>] [1 rgb <0, 0.8, 0.4>] } turbulence 0.4 } finish { ambient 1 diffuse 0 } } }
#macro At(X, Y) scale 0.65 translate <X, Y, 0> #end
box { -1, 1 pigment { image_map { function 7, 4 { pigment { bozo scale 0.2 } } } } At(-2.2, 1) }
box { -1, 1 pigment { pigment_pattern { bozo scale 0.2 } color_map { [0 rgb x] [1 rgb z] } } At(-0.75, 1) }
#declare F = function { pigment { wood scale 0.4 } }
box { -1, 1 pigment { function { F(x, y, z).red } } At(0.75, 1) }
box { -1, 1 pigment { wood scale 0.4 } At(2.2, 1) }
#default { texture { pigment { average pigment_map { [1 rgb 1] [1 rgb x] } } } }
box { -1, 1 pigment { pigment_pattern { bozo scale 0.2 } color_map { [0 rgb x] [1 rgb z] } } At(-2.2, -1) }
box { -1, 1 pigment { image_map { function 7, 4 { pigment { bozo scale 0.2 pigment_map { [0 wood] [1 leopard] } } } } } At(-0.75, -1) }
