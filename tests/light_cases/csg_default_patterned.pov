#version 3.7;
#include "csg.inc"
#default { texture { TC scale 2 } }
union { sphere { <-.8,0,0>, 1 rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
  box { <0,-1,-1>, 1 pigment { G } rotate 20*y } }
