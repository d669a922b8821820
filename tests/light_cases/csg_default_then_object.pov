#version 3.7;
#include "csg.inc"
#default { pigment { C } }
#declare O = union { sphere { <-.8,0,0>, 1 }
  box { <0,-1,-1>, 1 normal { bumps .8 scale .1 } } }
#default { pigment { G } }
object { O rotate 20*y }
  sphere { <0,1.5,0>, .5 }
