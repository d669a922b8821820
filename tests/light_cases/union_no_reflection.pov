#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
plane { y, -1.2 pigment { rgb .3 } finish { reflection .6 } }
// Mirrors do not show a union's or merge's part with no_reflection, wherever the group stands; those of an intersection they do.
intersection { union { sphere { <-1.9, 0, 0>, .7 no_reflection } sphere { <-1.2, .2, 0>, .6 } } pigment { rgb <.9, .3, .2> } }
merge { sphere { <.1, 0, 0>, .6 } sphere { <.5, .3, 0>, .6 no_reflection } pigment { rgb <.2, .4, .9> } }
intersection { sphere { <2, 0, 0>, .8 no_reflection } sphere { <2.3, .2, 0>, .8 } pigment { rgb <.9, .9, .2> } }
