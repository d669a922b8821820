#version 3.7;
#include "csg.inc"
intersection { box { -1, 1 texture { TC } }
union { sphere { <1,1,-1>, 1 texture { TG } rotate 10*y } cylinder { -2*y, 2*y, .5 } inverse } texture { TB } rotate 15*y }
