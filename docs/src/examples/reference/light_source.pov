#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> right x*image_width/image_height look_at <0, 0.8, 0> angle 42 }
light_source { <-3, 3, -3> rgb <1, 0.6, 0.3> fade_distance 4 fade_power 2 }
light_source { <40, 50, -60> rgb <0.1, 0.15, 0.3> }
plane { y, 0 pigment { checker srgb 0.85, srgb 0.72 } }
sphere { y, 1 pigment { srgb 0.9 } }
