// Where the pigment of a `pigment_pattern` lies outside of a picture that is there `once`, the pattern is 0; within an average it is white.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -2*z right 4*x up 3*y }
#default { finish { ambient 1 diffuse 0 } }
#declare Map = color_map { [0 rgb <0.2, 0.5, 0.9>] [1 rgb <1, 0.7, 0.1>] }
#declare Image = pigment { image_map { function 4, 3 { 0.2 + 0.5*x + 0.2*y } once } scale 1.5 }
box { <-2, 0, 0>, <0, 1.5, 1> pigment { pigment_pattern { Image } color_map { Map } translate <-2, 0, 0> } }
box { <0, 0, 0>, <2, 1.5, 1> pigment { pigment_pattern { average pigment_map { [1 Image] [3 Image] } } color_map { Map } } }
box { <-2, -1.5, 0>, <0, 0, 1> pigment { pigment_pattern { gradient x pigment_map { [0 Image] [1 rgb 0] } scale 4 } color_map { Map } translate <-2, -1.5, 0> } }
box { <0, -1.5, 0>, <2, 0, 1> pigment { pigment_pattern { checker pigment { Image } pigment { rgb 0.4 } scale 0.4 } color_map { Map } frequency 1.5 phase 0.2 translate -1.5*y } }
