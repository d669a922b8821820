// `ior` and `caustics` in finishes are those of the whole group, the last one for all; parts with an `interior` have their own.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
#declare Glass = pigment { rgbt <1, 1, 1, 0.8> };
union {
  sphere { <-1.3, 0.8, 0>, 0.6 pigment { Glass } }
  sphere { <0, 0.8, 0>, 0.6 pigment { Glass } finish { ior 1.2 caustics 30 } }
  union { sphere { <1.3, 0.8, 0>, 0.6 pigment { Glass } finish { ior 1.5 } } interior { ior 1.3 } }
  difference { sphere { <-1.3, -0.6, 0>, 0.6 } box { <-1.3, -2, -2>, <0, 0, 2> } pigment { Glass } finish { ior 1.4 } }
  sphere { <0, -0.6, 0>, 0.6 pigment { Glass } interior { ior 1.1 } }
  interior { ior 1.7 }
}
