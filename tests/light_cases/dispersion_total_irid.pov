#version 3.7; global_settings { assumed_gamma 1 }
camera { location -4*z look_at 0 }
background { rgb <0.18, 0.47, 0.1> }
box { -1, 1 rotate 30 texture { pigment { rgbft <0.88, 0.34, 0.43, 0.7, 0.2> } finish { ambient 0.1 irid { 0.5 thickness 0.25 } } } }
plane { y, 20 hollow pigment { rgbt 1 } interior { ior 1.27 dispersion 1.14 } }
