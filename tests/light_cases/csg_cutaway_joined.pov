#version 3.7;
#include "csg.inc"
#default { texture { pigment { rgb <.2, .9, .9> } } }
intersection { box { -1, 1 texture { TC } } union { sphere { -.4*x, .9 } sphere { .4*x, .9 texture { TG } } } cutaway_textures rotate 15*y }
