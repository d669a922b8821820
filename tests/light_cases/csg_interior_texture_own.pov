// What a group says of its inside is seen inside of parts with textures of their own too.
#version 3.7;
#include "csg.inc"
union {
  union { sphere { <-.8, 0, 0>, 1 texture { TC } } box { <.1, -.5, -.5>, <1, .5, .5> texture { TG } } texture { TB } interior_texture { TL } rotate 20*y clipped_by { plane { <.1, .2, -1>, .2 } } }
  union { sphere { <-.8, 1.8, 0>, .8 texture { TC } inverse } texture { TG } clipped_by { plane { -z, .2 } } }
  difference { box { <.1, .7, -.5>, <1, 1.6, .5> texture { TC } } cylinder { <.5, 1.2, -2>, <.5, 1.2, 2>, .3 texture { TG } } texture { TC }
  } texture { TG } interior_texture { TB scale .5 } }
