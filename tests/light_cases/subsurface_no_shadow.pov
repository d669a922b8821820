#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 3000, 300 } }
camera { orthographic location <0, 10, 0> direction -y right 2 * x up 1.5 * z }
light_source { <1000000, 0, 0>, rgb 1 parallel point_at 0 }
sphere { 0, 2 pigment { rgb <0.5, 0.7, 0.2> } finish { ambient 0 diffuse 1 subsurface { translucency 2 } } interior { ior 1.3 } no_shadow }
