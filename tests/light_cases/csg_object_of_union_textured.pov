#version 3.7;
#include "csg.inc"
#declare O = union { sphere { <-.8,0,0>, 1 scale .9 }
  box { <0,-1,-1>, 1 } texture { TG } rotate 30*z }
object { O texture { TC } rotate 20*y }
