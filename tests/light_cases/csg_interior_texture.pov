#version 3.7;
#include "csg.inc"
difference { box { -1, 1 texture { TC } interior_texture { TG } } plane { -z, .3 texture { TB } } clipped_by { plane { z, .5 } } rotate 15*y scale .9 }
