// The camera is inside the intersection, but not within the box of its parts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
media { emission 0.02 absorption 0.1 }
sphere { 0, 50 hollow no_shadow pigment { rgb 1 } finish { ambient 0.3 diffuse 0 } }
intersection { union { box { -1, 1 inverse } sphere { <0.5, 0, 0>, 0.5 } } plane { y, 100 } pigment { rgb x } }
