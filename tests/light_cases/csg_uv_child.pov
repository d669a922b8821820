#version 3.7;
#include "csg.inc"
difference { box { -1, 1 texture { uv_mapping pigment { gradient x scale <.25,1,1> rotate 30*z } rotate 20*z } }
  sphere { <1,1,-1>, 1.1 pigment { uv_mapping bozo scale .05 } } rotate 15*y }
