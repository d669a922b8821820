// A shape with an infinite number, or one that is moved by an infinite vector, is not seen.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 40 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
sphere { <-0.8, 0, 0>, 1/0 pigment { rgb <1, 0.2, 0.1> } }
sphere { 0, 0.8 pigment { rgb <0.2, 0.7, 0.1> } translate <1/0, 0, 0> }
box { <0.2, -0.6, 0>, <1.2, 0.6, 1> pigment { rgb <0.9, 0.8, 0.2> } }
