// A blob that needs no strength is everywhere; POV-Ray's camera is in it where its box is endless, as that of a blob without strong parts
// is as soon as it is moved. It is not hollow: there is no fog in it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 0, -6> }
fog { distance 8 rgb <0.7, 0.5, 0.3> }
plane { y, -2 hollow pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
blob { threshold -0.1 sphere { 0, 1, -0.05 } scale 1.5 pigment { rgb <0, 1, 0> } finish { ambient 1 diffuse 0 } }
