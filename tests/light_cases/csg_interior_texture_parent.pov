#version 3.7;
#include "csg.inc"
union { sphere { <-.8,0,0>, 1 }
  box { <0,-1,-1>, 1 texture { TB } interior_texture { TG } } texture { TC } interior_texture { TL scale 2 } clipped_by { plane { <-.3,.2,-1>, .2 } } rotate <20, 30, 10> scale <1.2, .8, 1> translate <.2, .1, 0> }
