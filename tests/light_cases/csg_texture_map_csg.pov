#version 3.7;
#include "csg.inc"
difference { box { -1, 1 }
  sphere { <1,1,-1>, 1.1 scale .9 } texture { gradient x texture_map { [0 TC] [.5 TG scale .5] [1 TL] } scale .8 rotate 20*z } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
