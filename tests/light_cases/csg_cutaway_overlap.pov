#version 3.7;
#include "csg.inc"
difference { union { box { <-1, -1, -1>, <.4, 1, 1> texture { TC } } box { <-.4, -1, -1>, 1 texture { TG } } }
  sphere { <0, .5, -1>, .9 } cutaway_textures rotate 15*y }
