#version 3.7;
global_settings { assumed_gamma 1 }
light_group {
  light_source { <-4, 7, -5> rgb <1, 0.4, 0.3> }
  sphere { <-2.2, 0.7, 0>, 0.7 pigment { srgb 0.9 } }
  global_lights off
}
light_source { <4, 7, -5> rgb 0.9 }
camera { location <0, 3, -9> right x*image_width/image_height look_at <0, 0.8, 0> angle 42 }
plane { y, 0 pigment { checker srgb 0.85, srgb 0.72 } }
sphere { y, 1 pigment { srgb 0.9 } }
box { <1.4, 0, -0.6>, <2.2, 1.4, 0.4> pigment { srgb <0.8, 0.5, 0.3> } }
