#version 3.7;
#include "csg.inc"
#default { texture { pigment { rgb <.2, .9, .9> } } }
difference { box { -1, 1 texture { TC } } union { sphere { <.4, .5, -1>, .7 } sphere { <-.5, .2, -1>, .6 } }
  intersection { sphere { <.3, -.5, -1>, .7 } sphere { <-.1, -.6, -1>, .7 } } cutaway_textures rotate 15*y }
