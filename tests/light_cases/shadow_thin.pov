// A surface that is no farther behind another than 0.001 takes nothing of a light's ray.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 3, 0> direction -y right 4*x up 3*z }
light_source { <0, 10, 0> rgb 1 parallel point_at 0 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#default { finish { ambient 0 diffuse 0 } }
#macro Films(X, A, B, C) triangle { <X, A, -9>, <X + 0.9, A, -9>, <X, A, 99> pigment { rgb <1, 0.5, 0.5> filter 0.5 } no_image }
  triangle { <X, B, -9>, <X + 0.9, B, -9>, <X, B, 99> pigment { rgb <0.5, 1, 0.5> filter 0.5 } no_image }
  triangle { <X, C, -9>, <X + 0.9, C, -9>, <X, C, 99> pigment { rgb <0.5, 0.5, 1> filter 0.5 } no_image } #end
Films(-2, 1, 1.0006, 1.0012)
Films(-1, 1.002, 1.0012, 1.0003)
box { <0, 1, -9>, <0.9, 1.0009, 9> pigment { rgb 0.8 filter 0.9 } no_image }
box { <1, 1, -9>, <1.9, 1.0011, 9> pigment { rgb 0.8 filter 0.9 } no_image }
