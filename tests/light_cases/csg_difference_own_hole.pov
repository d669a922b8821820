#version 3.7;
#include "csg.inc"
difference { box { -1, 1 texture { TG } }
  sphere { <1,1,-1>, 1.1 texture { TB } scale 1.1 } rotate 15*y }
