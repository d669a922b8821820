// What is no number shows the first entry of a map; a normal that is none, or that is endless, blackens all that is seen of it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 50 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
#declare Map = color_map { [0.2 rgb <1, 0.2, 0.1>] [0.6 rgb <0, 1, 0.3>] [0.8 rgb <0.2, 0.4, 1>] }
#declare Lit = finish { ambient 0.6 diffuse 0.3 }
#macro At(X, Y) scale 0.6 translate <X, Y, 0> #end
sphere { 0, 1 pigment { function { sqrt(x) } color_map { Map } frequency 3 phase 0.3 } finish { Lit } At(-2.2, 1) }
sphere { 0, 1 pigment { crackle metric 2.5 offset -0.6 color_map { Map } } finish { Lit } At(-0.75, 1) }
box { -0.9, 0.9 pigment { checker rgb <1, 0.5, 0>, rgb <0, 0.5, 1> frequency 2 poly_wave -1 scale 0.4 translate -0.01 } finish { Lit } At(0.75, 1) }
sphere { 0, 1 texture { function { ln(x) } texture_map { [0 pigment { rgb <0.9, 0.6, 0> } finish { Lit }] [1 pigment { rgb <0, 0.6, 0.9> } finish { Lit }] } } At(2.2, 1) }
sphere { 0, 1 pigment { rgb 1 } normal { function { sqrt(x) } 0.5 } finish { Lit } At(-2.2, -1) }
sphere { 0, 1 pigment { rgb 1 } normal { function { sqrt(x) } 0.5 slope_map { [0 <0, 1>] [1 <1, -1>] } } finish { Lit } At(-0.75, -1) }
sphere { 0, 1 texture { pigment { rgb 1 } normal { function { 1/max(0, x) } 0.5 } finish { Lit } } texture { pigment { rgbt <1, 0.5, 0.5, 0.6> } finish { Lit } } At(0.75, -1) }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 0.1 diffuse 0.3 reflection 0.5 } At(2.2, -1) }
