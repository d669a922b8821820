#version 3.7;
global_settings { assumed_gamma 1 }
background { srgb <0.6, 0.7, 0.8> }
fog { fog_type 2 distance 12 srgb <0.85, 0.88, 0.9> fog_offset 0.4 fog_alt 0.8 }
camera { location <0, 1.6, -8> right x*image_width/image_height look_at <0, 1.8, 0> angle 60 }
light_source { <-40, 50, -60> rgb 1 }
plane { y, 0 pigment { srgb <0.45, 0.55, 0.3> } }
#for (I, 1, 9) cone { <4 - mod(I*3, 8), 0, I*4 - 4>, 0.9, <4 - mod(I*3, 8), 3, I*4 - 4>, 0 pigment { srgb <0.2, 0.4, 0.2> } } #end
