#version 3.7;
#include "csg.inc"
difference { intersection { box { -1, 1 texture { TC } }
  sphere { 0, 1.3 } }
  box { <0,0,-2>, 2 } texture { TG } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
