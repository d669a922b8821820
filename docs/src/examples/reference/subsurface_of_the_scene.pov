#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 25.4 subsurface { samples 60, 20 } }
camera { location <0, 3, -9> right x*image_width/image_height look_at <0, 0.8, 0> angle 42 }
light_source { <-5, 6, 3> rgb 1 }
plane { y, 0 pigment { srgb 0.6 } }
box { <-1, 0, -1>, <1, 1.4, 1>
  pigment { rgb <0.5, 0.85, 0.6> }
  finish { diffuse 0.9 specular 0.4 subsurface { translucency 4 } }
  interior { ior 1.4 }
  rotate 30*y
}
