#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
plane { z, 5 pigment { checker rgb <.6, .5, .4> rgb <.3, .9, .7> } finish { reflection .3 } }
// The camera does not see a merge's part with no_image, which then hides no other part of it; what is around the merge does not know.
merge { sphere { <-1.6, .9, 0>, .9 } sphere { <-.9, .9, 0>, .9 no_image } pigment { rgbt <.9, .3, .2, .4> } }
intersection { merge { sphere { <.9, 1, 0>, .9 } sphere { <1.8, 1, 0>, .8 no_image } } box { <0, .2, -.6>, <3, 2, 2> } pigment { rgb <.2, .4, .9> } }
intersection { merge { sphere { <-1.5, -1, 0>, .8 } sphere { <-1, -1, 0>, .8 } no_image } pigment { rgb <.9, .9, .2> } }
difference { box { <.3, -1.9, -.5>, <2.4, -.3, 1> } intersection { sphere { <1, -1, -.5>, .7 no_image } sphere { <1.4, -1, -.5>, .7 } } pigment { rgbt <.4, .8, .4, .5> } }
