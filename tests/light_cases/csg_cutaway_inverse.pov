#version 3.7;
#include "csg.inc"
intersection { box { -1, 1 texture { TC } } sphere { <.4, .5, -1>, .9 texture { TG } inverse } sphere { <-.4, -.3, -1>, .7 inverse } cutaway_textures rotate 15*y }
