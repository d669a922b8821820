#version 3.7;
#include "csg.inc"
#declare O = sphere { 0, 1.3 texture { TG } }
object { O pigment { C } scale .8 }
object { O normal { bumps 1 scale .1 } translate <1.5,1,0> scale .7 }
object { O finish { ambient .6 } translate <-1.5,1,0> scale .7 }
