#version 3.7;
#include "csg.inc"
union { sphere { <-.8,0,0>, 1 scale <1,.7,1> texture { TC } rotate 40*z }
  box { <0,-1,-1>, 1 texture { TG } scale .8 } rotate 20*x }
