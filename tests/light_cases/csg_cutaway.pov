#version 3.7;
#include "csg.inc"
difference { box { -1, 1 texture { TC } }
  sphere { <1,1,-1>, 1.1 } cylinder { -2*z, 2*z, .4 } cutaway_textures rotate 15*y }
