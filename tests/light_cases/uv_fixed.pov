#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
// What is mapped by uv is moved in its own block only.
#declare P = pigment { uv_mapping gradient x color_map { [0 rgb <1, 0, .2>] [1 rgb <.2, 1, 0>] } scale .7 }
#declare T = texture { uv_mapping pigment { gradient y color_map { [0 rgb <1, 0, .2>] [1 rgb <.2, 1, 0>] } } scale .4 }
#declare N = normal { uv_mapping bumps 1 scale .1 }
sphere { <-2, 1, 0>, .9 texture { pigment { P } scale 2 } }
sphere { <0, 1, 0>, .9 pigment { P scale 3 translate .3 } }
sphere { <2, 1, 0>, .9 texture { T scale 2 } }
box { -.6, .6 texture { T rotate 30*y translate .2 } rotate <20, 30, 0> translate <-2, -1, 0> }
box { -.6, .6 texture { pigment { rgb .7 } normal { N scale 3 } scale 2 } rotate <20, 30, 0> translate <0, -1, 0> }
box { -.6, .6 texture { uv_mapping pigment { uv_mapping gradient x scale .3 } scale 3 } rotate <20, 30, 0> translate <2, -1, 0> }
