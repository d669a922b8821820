#version 3.7;
global_settings { assumed_gamma 1 }
light_source {
  <-4, 7, -5> rgb 1
  area_light 3*x, 3*z, 9, 9 adaptive 1 circular orient
}
camera { location <0, 3, -9> right x*image_width/image_height look_at <0, 0.8, 0> angle 42 }
plane { y, 0 pigment { checker srgb 0.85, srgb 0.72 } }
sphere { y, 1 pigment { srgb 0.9 } }
box { <1.4, 0, -0.6>, <2.2, 1.4, 0.4> pigment { srgb <0.8, 0.5, 0.3> } }
