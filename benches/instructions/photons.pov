// Caustics of a glass ball on a table.
#version 3.7;
global_settings { assumed_gamma 1 photons { count 20000 } }
camera { location <0, 3, -6> look_at 0 angle 45 }
light_source { <3, 8, 2> rgb 1 photons { refraction on reflection on } }
plane { y, -1 pigment { rgb 0.8 } photons { collect on } }
sphere { 0, 1 pigment { rgbf 0.95 } finish { specular 0.6 reflection 0.1 } interior { ior 1.5 } photons { target refraction on reflection on collect off } }
