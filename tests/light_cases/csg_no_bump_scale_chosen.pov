// `no_bump_scale` of normals that a pattern chooses: neither the pattern's size nor the object's deepens them.
#version 3.7;
#include "csg.inc"
#default { pigment { rgb .8 } }
#declare N = normal { bumps .6 scale .3 no_bump_scale }
union {
  sphere { <-.8, 0, 0>, 1 texture { checker texture { N } texture { N finish { phong .5 } } scale .3 rotate 30 } scale <.8, 1.2, 1> }
  box { <0, -1, -1>, 1 texture { bozo texture_map { [0 gradient x texture_map { [.4 N ] [.6 normal { bumps 1 }] } scale .5] [1 N] } scale <.3, .6, 2> } }
  box { <-1, 1.1, -.5>, <1, 2, .5> texture { average texture_map { [1 N] [1 normal { wrinkles 1 no_bump_scale scale .2 }] } scale .5 } } scale <1.2, .6, 1> }
