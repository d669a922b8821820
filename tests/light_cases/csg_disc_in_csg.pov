#version 3.7;
#include "csg.inc"
union { disc { 0, y, 1.5 texture { TC } } triangle { <-1,0,0>, <1,0,0>, <0,1.5,0> } polygon { 5, <-1,-1,0>, <1,-1,0>, <1,-.2,0>, <-1,-.2,0>, <-1,-1,0> pigment { G } } texture { TB } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
