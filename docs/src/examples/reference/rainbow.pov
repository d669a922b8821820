#version 3.7;
global_settings { assumed_gamma 1 }
background { srgb <0.45, 0.52, 0.6> }
rainbow {
  direction <0.1, -0.35, 1> angle 30 width 7 arc_angle 220 falloff_angle 120
  color_map { [0 srgbt <0.6, 0, 0.8, 0.9>] [0.3 srgbt <0, 0.4, 1, 0.5>] [0.5 srgbt <0, 0.8, 0.2, 0.4>]
              [0.7 srgbt <1, 0.9, 0, 0.4>] [1 srgbt <1, 0, 0, 0.9>] }
}
camera { location <0, 1.6, -8> right x*image_width/image_height look_at <0, 1.8, 0> angle 60 }
light_source { <-40, 50, -60> rgb 1 }
plane { y, 0 pigment { srgb <0.45, 0.55, 0.3> } }
#for (I, 1, 9) cone { <4 - mod(I*3, 8), 0, I*4 - 4>, 0.9, <4 - mod(I*3, 8), 3, I*4 - 4>, 0 pigment { srgb <0.2, 0.4, 0.2> } } #end
