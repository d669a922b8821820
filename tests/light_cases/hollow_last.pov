// The camera is in the air of three objects, which is hollow as the last shape of each says: fog is seen but where one is not hollow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-0.5, 0.5, -0.7> }
light_source { <0.3, 9, -4> rgb <1, 1, 0> }
fog { distance 8 rgb <1, 0, 0> }
#default { pigment { rgb 1 } }
union { box { -1, 1 } sphere { 9, 1 hollow } }
merge { sphere { 9, 1 } intersection { sphere { 0, 4 } box { -2, 2 hollow } } }
difference { box { -3, 3 interior { ior 1.1 } hollow } sphere { 9, 1 hollow } }
