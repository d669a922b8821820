#version 3.7;
#include "csg.inc"
#default { pigment { G } finish { ambient .3 } } difference { box { -1, 1 texture { TC } }
  sphere { <1,1,-1>, 1.1 } rotate 15*y }
