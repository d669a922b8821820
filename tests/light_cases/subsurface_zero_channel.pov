#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 100, 100 } }
camera { orthographic location <0, 10, 0> direction -y right 2 * x up 1.5 * z }
light_source { <0, 1000000, 0>, rgb 0.5 parallel point_at 0 }
box { <-20, -5, -20>, <20, 0, 20> pigment { rgb <0.5, 0, 0.5> } finish { ambient 0 diffuse 1 subsurface { translucency 1 } } }
