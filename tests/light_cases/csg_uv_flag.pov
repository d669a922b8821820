// `uv_mapping` of a group: its parts' textures see (u, v), as they were moved up to the end of its block.
#version 3.7;
#include "csg.inc"
#declare Flagged = union { box { <-1, -1, -1>, <0, 0, 0> texture { TC } rotate 20*y } uv_mapping rotate 10*x }
union { object { Flagged rotate 20*z }
  difference { sphere { <.5, .6, 0>, .6 texture { TB } } box { <.5, .5, -1>, <2, 2, 0> uv_mapping } uv_mapping texture { TG } rotate 30*y }
  intersection { box { <0, -1, -1>, <1, 0, 0> uv_mapping } cylinder { <.5, -1, -.5>, <.5, 0, -.5>, .6 } texture { TC scale .5 } rotate <10, 20, 0> }
  box { <-1, .1, -.2>, <-.2, 1, .4> uv_mapping texture { TG } scale 1.1 rotate 30 } rotate 10 }
