#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
plane { z, 5 pigment { checker rgb <.6, .5, .4> rgb <.3, .9, .7> } }
// Textures of a blend reflect, reflect totally and refract each by itself: what is seen is the sum of their pictures.
#default { finish { ambient .1 diffuse .3 } }
#macro Blend(A, B) texture { function { .25 } texture_map { [0 A] [1 B] } } #end
#declare Clear = texture { pigment { rgbf .8 } }
#declare Bumpy = texture { pigment { rgbf <.9, .8, .7, .9> } normal { bumps 1 scale .3 } }
#declare Mirror = texture { pigment { rgb .3 } finish { reflection .4 } }
#declare Glazed = texture { pigment { rgbf .8 } finish { reflection .3 } }
box { -.7, .7 Blend(Clear, texture { pigment { rgb .2 } }) interior { ior .6 } rotate <30, 40, 0> translate <-2, 1, 0> }
sphere { <0, 1, 0>, .9 Blend(Clear, Bumpy) interior { ior 1.3 } }
box { -.7, .7 Blend(Glazed, Mirror) interior { ior .6 } rotate <30, 40, 0> translate <2, 1, 0> }
sphere { <-2, -1, 0>, .9 Blend(Glazed, Bumpy) interior { ior 1.5 } }
box { -.7, .7 Blend(Glazed, texture { checker texture { Clear } texture { Mirror } scale .2 }) interior { ior 1.8 } rotate <30, 40, 0> translate <0, -1, 0> }
sphere { <2, -1, 0>, .9 texture { average texture_map { [1 Clear] [2 Bumpy] [1 Mirror] } } interior { ior .7 } }
