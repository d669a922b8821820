// A part with a texture of its own inside does not follow `uv_mapping` of a group; what shows where it is cut, and its inside do.
#version 3.7;
#include "csg.inc"
#declare Half = box { <-1, -1, -1>, <0, 1, 1> texture { TC } interior_texture { TB } clipped_by { plane { <.3, 1, -1>, .2 } } rotate 20*y }
union {
  union { object { Half scale .8 translate -.3*x } uv_mapping }
  box { <0, -1, -1>, 1 uv_mapping texture { TG } interior_texture { TC } clipped_by { plane { <-.3, 1, -1>, .1 } } rotate 10*y scale .7 translate .7*x }
  difference { box { <-.5, .8, -.5>, <.5, 1.8, .5> texture { TB } rotate 10*y } box { <-1, 1, -1>, <0, 3, 0> rotate 20*y uv_mapping } cutaway_textures } }
