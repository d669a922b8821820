// A plain scene: textures, glass, a mirror and two lights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 1, 0> angle 50 }
light_source { <5, 8, -6> rgb 0.8 }
light_source { <-6, 4, -5> rgb 0.4 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.1, 0.2, 0.6>] } } }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.6> } finish { reflection 0.1 } }
sphere { <-1.6, 1, 0>, 1 pigment { marble color_map { [0 rgb 0.9] [1 rgb <0.5, 0.2, 0.1>] } turbulence 0.6 } finish { phong 0.6 } }
sphere { <1.4, 1, -1>, 1 pigment { rgbf <0.95, 0.97, 1, 0.95> } finish { specular 0.8 reflection { 0.05, 0.9 fresnel } conserve_energy } interior { ior 1.5 } }
cylinder { <0, 0, 2>, <0, 2.6, 2>, 0.8 pigment { rgb 0.1 } finish { reflection 0.7 specular 0.6 } }
box { <-0.6, 0, -2>, <0.2, 0.5, -1.2> pigment { wood scale 0.2 turbulence 0.1 color_map { [0 rgb <0.6, 0.4, 0.2>] [1 rgb <0.3, 0.15, 0.05>] } } normal { bumps 0.3 scale 0.05 } }
