#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 1.6, -9> look_at <0, 1, 0> angle 70 right x*image_width/image_height
  normal { hexagon 0.4 rotate 90*x scale 0.08 }
}
light_source { <-6, 9, -4> rgb 1 }
background { srgb <0.72, 0.82, 0.92> }
plane { y, 0 pigment { checker srgb 0.85, srgb 0.6 } }
#for (I, 0, 11)
  cylinder { <0, 0, 5>, <0, 2.4, 5>, 0.35 pigment { srgb <0.8, 0.2 + I/20, 0.1> } rotate I*30*y }
#end
