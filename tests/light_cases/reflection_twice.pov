#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic angle 45 location <1.9, 2, -4> look_at 0 }
light_source { <5.7, 3.9, -6> 1 }
background { rgb <.2, .4, .6> }
#default { pigment { rgb <1, .5, .2> } finish { reflection { .5 fresnel } } }
sphere { <-1, 0, 0>, .5 finish { reflection { .3, .6 } } interior { ior 1.5 } }
sphere { 0, .5 finish { reflection { .3 } reflection { .1, .9 metallic } } interior { ior 1.5 } }
sphere { <1, 0, 0>, .5 finish { reflection .4 reflection { .1, .9 } } interior { ior 1.5 } }
sphere { <0, 1, 0>, .5 finish { reflection { .4 } } interior { ior 1.5 } }
sphere { <0, -1, 0>, .5 finish { reflection { .1, .7 fresnel off } } interior { ior 1.5 } }
