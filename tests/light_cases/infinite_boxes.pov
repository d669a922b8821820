// Boxes with infinite corners, also in CSG under rotation.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
#declare Inf = 1e308 * 10;
box { <-Inf, -1.2, -1>, <Inf, -0.6, 1> pigment { rgb <1, 0.4, 0.2> } translate 0.1*y }
intersection { box { <-Inf, -0.4, -1>, <0.2, Inf, 1> } sphere { 0, 1 } pigment { rgb <0.4, 1, 0.2> } rotate 20*z }
difference { sphere { <1.4, 0.8, 0>, 0.7 } box { <1.4, 0.5, -Inf>, Inf } pigment { rgb <0.8, 0.4, 1> } }
box { <-0.2, -Inf, -1>, <0.2, Inf, -0.8> pigment { rgbt <1, 0.9, 0.5, 0.7> } interior { ior 1.2 } scale <0.5, 1, 1.2> translate -1.2*x }
box { <-Inf, 0.9, 1>, <Inf, Inf, 1.3> clipped_by { box { <-Inf, -Inf, -9>, <-0.3, Inf, 9> } } pigment { rgb <0.2, 0.9, 0.9> } }
intersection { box { <-Inf, -0.3, -Inf>, <Inf, 0.2, Inf> inverse } sphere { <1, -0.2, -1.6>, 0.3 } pigment { rgb <0.9, 0.9, 0.2> } }
