// A quadric that is turned inside out, or taken away, shows the texture of its inside where that was; a sphere does not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6*z angle 30 }
#default { finish { ambient 1 diffuse 0 } }
#macro Sides() texture { pigment { rgb 1 } } interior_texture { pigment { rgb <1, 0.3, 0.1> } } #end
difference { box { <-1.4, 0.2, -0.5>, <-0.2, 1, 0> } quadric { 1, 0, 0, -0.1 translate <-0.8, 0.6, -0.5> } Sides() }
difference { box { <0.2, 0.2, -0.5>, <1.4, 1, 0> } sphere { <0.8, 0.6, -0.5>, 0.316 } Sides() }
quadric { <1, 2, 3>, 0, 0, -0.2 inverse Sides() translate <-0.8, -0.5, 0> }
difference { box { <0.2, -1, -0.5>, <1.4, -0.2, 0> } quadric { 0, 0, <0.3, 0, 1>, 0 rotate 20*y } Sides() }
