#version 3.7;
global_settings { assumed_gamma 1 }
// The light is on the side of du x dv in one sheet, and behind it in the other.
camera { location <0, 0, -4> angle 50 }
light_source { <1, 2, -6>, 1 }
#declare Look = texture { pigment { rgb 1 } finish { ambient .1 diffuse .7 specular .4 } }
parametric { function { u } function { v } function { .3*u*u - .2*v } <-1, -1>, <1, 1> contained_by { box { -2, 2 } } max_gradient 2 accuracy 1e-7
    texture { Look } interior_texture { pigment { rgb <1, 0, 0> } } scale .8 translate -.9*x }
parametric { function { v } function { u } function { .3*u*u - .2*v } <-1, -1>, <1, 1> contained_by { box { -2, 2 } } max_gradient 2 accuracy 1e-7
    texture { Look } interior_texture { pigment { rgb <0, 0, 1> } } scale .8 translate .9*x }
