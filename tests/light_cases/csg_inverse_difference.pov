#version 3.7;
#include "csg.inc"
difference { box { -1, 1 texture { TC } } difference { sphere { <1,1,-1>, 1.2 texture { TG } }
  sphere { <1,1,-1>, .8 texture { TB } } } rotate 15*y }
