#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 2, -9> look_at <0, 1.6, 0> angle 45 right x*image_width/image_height
  aperture 1.2 focal_point <0, 1, -5> blur_samples 60 variance 0
  bokeh { pigment {                        // a lens with a dark middle, as one that is made of mirrors has
    spherical scale 0.5 translate <0.5, 0.5, 0>
    color_map { [0 rgb 0] [0.01 rgb 1] [0.4 rgb 1] [0.41 rgb 0] }
  } }
}
light_source { <-6, 9, -8> rgb 0.8 }
plane { y, 0 pigment { checker srgb 0.3, srgb 0.2 } }
sphere { <0, 0.7, -5>, 0.7 pigment { srgb <0.9, 0.5, 0.2> } finish { phong 0.6 } }
#for (I, 0, 8)                             // lamps far behind
  sphere { <I*3 - 12, 2.5 + 1.6*sin(I*2.3), 14>, 0.25 pigment { srgb <1, 0.8, 0.55> } finish { ambient 8 } }
#end
