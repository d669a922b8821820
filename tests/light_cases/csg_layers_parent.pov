#version 3.7;
#include "csg.inc"
difference { box { -1, 1 }
  sphere { <1,1,-1>, 1.1 rotate 40*x } texture { TL scale 1.3 rotate 10*z } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
