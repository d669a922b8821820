#version 3.7;
global_settings { assumed_gamma 1 }
#default { camera { location <0, 0, -9> } }
box { <-1, -1, 2>, <1, 1, 3> pigment { gradient x } finish { ambient 1 } }
