#version 3.7;
#include "csg.inc"
#declare M = material { texture { TC scale 1.5 } interior { ior 1.2 } }
union { sphere { <-.8,0,0>, 1 material { M } scale .9 }
  box { <0,-1,-1>, 1 } material { M rotate 30*z } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
