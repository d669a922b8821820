// The same in shadows: light that passes a cavity.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> angle 20 look_at 0 }
difference { box { -0.77, <0.77, 0.77, 0.3> } quadric { 1, 0, 0, -0.4 } texture { pigment { rgbf 1 } } interior_texture { pigment { rgbf <1, 0.3, 0.1, 0.9> } } }
plane { -y, -2 pigment { rgb 1 } rotate x*40 finish { ambient 0 diffuse 1 } }
light_source { <0, 4, 0> 1 }
