#version 3.7;
#include "csg.inc"
union { sphere { <-.8,0,0>, 1 } torus { 1, .4 translate x } texture { pigment { uv_mapping gradient y scale .2 } normal { uv_mapping bumps 1 scale .05 } } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
