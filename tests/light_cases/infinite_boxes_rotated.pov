// Rotated boxes with infinite corners.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
#declare Inf = 1e308 * 10;
box { <-Inf, -1.2, -1>, <Inf, -0.6, 1> pigment { rgb <1, 0.4, 0.2> } rotate 20*z }
intersection { box { -1, <1, Inf, 1> rotate <10, 20, 30> } sphere { 0, 1.2 } pigment { rgb <0.4, 1, 0.2> } }
