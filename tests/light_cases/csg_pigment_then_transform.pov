#version 3.7;
#include "csg.inc"
union { sphere { <-.8,0,0>, 1 pigment { C } scale .8 normal { bumps 1 scale .1 } rotate 30*z finish { phong .5 } }
  box { <0,-1,-1>, 1 scale .8 pigment { G } } rotate 20*y }
