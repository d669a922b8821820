#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 3000, 300 } }
camera { orthographic location <0, 10, 0> direction -y right 2 * x up 1.5 * z }
light_source { <0, 1000000, 0>, rgb 0.5 parallel point_at 0 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, 0 pigment { rgb 0.5 transmit 0.4 } finish { ambient 0 diffuse 1 subsurface { translucency 1 } } }
