#version 3.7;
#include "csg.inc"
difference { box { -1, 1 texture { TC } rotate 20*x }
  sphere { <1,1,-1>, 1.1 scale .9 } cutaway_textures rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
