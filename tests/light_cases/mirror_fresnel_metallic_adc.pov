#version 3.7;
// How much the ray of a metallic mirror with fresnel counts, the metal's colour does not tell: half of these end between the two.
global_settings { assumed_gamma 1 adc_bailout 0.16 }
camera { location <0, 2, -3> look_at <0, 0, 0> angle 60 }
background { rgb <0.9, 0.8, 0.7> }
plane { y, 0 pigment { gradient x color_map { [0 rgb <0.1, 0.5, 0.2>] [1 rgb <1.6, 0.5, 0.2>] } scale 3 translate -1.5*x }
  finish { ambient 0 diffuse 0.2 reflection { 0.1, 0.5 fresnel metallic } } interior { ior 1.5 } }
light_source { <2, 5, -2> 1 }
