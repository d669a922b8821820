#version 3.7;
#include "csg.inc"
union { sphere { <-.8,0,0>, 1 texture { pigment { rgb .8 } normal { bumps .5 scale .2 } no_bump_scale scale 2 } scale .8 }
  box { <0,-1,-1>, 1 texture { TC no_bump_scale scale 3 } } scale <1.2,.6,1> }
