#version 3.7;
#include "csg.inc"
merge { sphere { <-.5,0,0>, 1 }
  sphere { <.5,0,0>, 1 texture { TL } rotate 40*x } texture { TG } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
