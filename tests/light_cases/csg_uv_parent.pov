#version 3.7;
#include "csg.inc"
union { sphere { <-.8,0,0>, 1 }
  box { <0,-1,-1>, 1 rotate 20*y } texture { uv_mapping pigment { checker rgb <.9,.2,.2> rgb <.2,.9,.3> scale .125 } } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
