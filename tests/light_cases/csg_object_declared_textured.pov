#version 3.7;
#include "csg.inc"
#declare O = sphere { 0, 1.3 texture { TG } scale <1,.7,1> }
object { O rotate 20*y texture { TC } scale .9 }
object { O translate <0,1.5,0> scale .6 }
