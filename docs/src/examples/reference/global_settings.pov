#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <0.4, 0.8, 1.6> max_trace_level 10 }
camera { location <0, 3, -9> right x*image_width/image_height look_at <0, 0.8, 0> angle 42 }
light_source { <-40, 80, -60> rgb 1 }
plane { y, 0 pigment { checker srgb 0.85, srgb 0.72 } finish { ambient 0.2 } }
sphere { y, 1 pigment { srgb 0.9 } finish { ambient 0.2 } }
