#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
// A map without a pattern is black; another pattern takes away the colours of a default one; noise generators of both add their bits;
// a slope with altitude begins anew outside of 0 to 1 before its frequency counts.
sphere { <-2, 1, 0>, .9 pigment { color_map { [0 rgb x] [1 rgb y] } } finish { ambient .5 } }
#default { pigment { wrinkles noise_generator 1 } }
sphere { <0, 1, 0>, .9 pigment { bozo scale .4 } }
sphere { <2, 1, 0>, .9 pigment { wrinkles noise_generator 2 scale .5 } }
sphere { <-2, -1, 0>, .9 pigment { checker pigment { wrinkles noise_generator 2 } pigment { rgb 1 } scale .6 } }
sphere { <0, -1, 0>, .9 pigment { slope { <1, 1, 1> altitude <1, 1, 1> } frequency 1.7 color_map { [0 rgb 0] [1 rgb 1] } } }
// What counts for less than nothing has no power.
sphere { <2, -1, 0>, .9 pigment { rgbft 1 } finish { reflection { .5 exponent 1.2 } } }
