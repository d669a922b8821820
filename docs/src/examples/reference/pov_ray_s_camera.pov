#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 2, -6>
  right x*image_width/image_height
  look_at <0, 0.8, 0>
  angle 50
}
light_source { <-4, 6, -4> rgb 1 }
background { srgb <0.72, 0.82, 0.92> }
plane { y, 0 pigment { checker srgb 0.85, srgb 0.72 } }
sphere { y, 1 pigment { srgb <0.8, 0.3, 0.1> } }
