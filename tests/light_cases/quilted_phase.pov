#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
#default { finish { ambient 1 diffuse 0 } }
// Some names set the frequency to 0, so that phase counts for nothing; it stays 0 for the next name.
#declare Q = pigment { quilted phase .3 color_map { [0 rgb <1, 0, .2>] [1 rgb <.2, 1, 0>] } }
#declare R = pigment { gradient x phase .4 frequency 2 color_map { [0 rgb <1, 0, .2>] [1 rgb <.2, 1, 0>] } }
box { <-3, .1, 0>, <-.1, 2.2, 1> pigment { Q scale .6 } }
box { <.1, .1, 0>, <3, 2.2, 1> pigment { Q frequency 1 scale .6 } }
box { <-3, -2.2, 0>, <-.1, -.1, 1> pigment { Q gradient x } }
box { <.1, -2.2, 0>, <3, -.1, 1> pigment { R quilted phase .2 scale .7 } }
