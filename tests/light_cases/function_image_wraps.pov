#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*4 up y*3 }
// Of a picture that a function makes, numbers are kept in 16 bits: what lies outside of 0 to 1 begins anew.
box { <-2, -1.5, 0>, <0, 1.5, 1> pigment { image_map { function 8, 8 { x*2.3 - 1.1*y } } translate <-1, -.5, 0> scale <2, 3, 1> } finish { ambient 1 diffuse 0 } }
box { <0, -1.5, 0>, <2, 1.5, 1> pigment { image_map { function 4, 3 { x - 1.6 } interpolate 2 } translate <0, -.5, 0> scale <2, 3, 1> } finish { ambient 1 diffuse 0 } }
