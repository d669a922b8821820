#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right x*4 up y*3 }
background { rgb <0.1, 0.3, 0.2> }
#default { finish { ambient 1 diffuse 0 } }
// Pictures of functions keep 16 bits of each number, and lose the rest; so do those of pigments, and their alpha.
#declare Number = function { pattern { image_pattern { function 4, 3 { 0.25 + x/8 + y/64 } } } }
#declare Colour = function { pigment { image_map { function 4, 3 { pigment { rgbt <0.25, 0.7, 0.1, 0.33> } } } } }
#macro Place(X, Y) scale <2, 1, 1> translate <X, Y, 0> #end
box { 0, 1 pigment { function { mod(Number(x, y, z)*65535, 1) } } Place(-2, 0.5) }
box { 0, 1 pigment { function { mod(Colour(x, y, z).red*65535, 1) } } Place(0, 0.5) }
box { 0, 1 pigment { function { mod(Colour(x, y, z).transmit*65535, 1) } } Place(-2, -0.5) }
// What lies below 0 or above 1 comes round again.
box { 0, 1 pigment { image_map { function 4, 4 { pigment { rgbt <-0.3, 1.4, 2.5, -0.3> } } } } finish { ambient 0.7071 } Place(0, -0.5) }
box { 0, 1 pigment { image_map { function 4, 4 { pigment { gradient x color_map { [0 rgb -0.6] [1 rgb <1, 2, 3>] } scale 2 } } } } finish { ambient 0.7071 } Place(-2, -1.5) }
// a mirror of what such bumps look at
box { <0, -1.5, 0>, <2, -0.5, 1> pigment { rgb 0 } finish { ambient 0 reflection 1 } normal { bump_map { function 4, 4 { select(x - 0.3, 0.25, 0.75) } } } }
sphere { 0, 1000 hollow pigment { function { x/0.4 } triangle_wave color_map { [0 rgb 0] [1 rgb 1] } } no_image }
