#version 3.7; global_settings { assumed_gamma 1 adc_bailout 0.3 }
// Corners whose share is less than adc_bailout are missing twice from the light that a triangle lets through.
camera { orthographic location <0, 5, -5> look_at 0 right x*6.4 up y*4.8 }
light_source { 10*y 1 parallel point_at 0 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare T1 = texture { pigment { rgbt <1, 1, 1, 0.9> } }
#declare T2 = texture { pigment { rgbf <0.4, 0.8, 1, 0.8> } }
#declare T3 = texture { pigment { rgb 1 } }
mesh { triangle { <-3, 1, -3>, <3, 1, -3>, <0, 1, 3> texture_list { T1, T2, T1 } } no_image }
mesh { triangle { <3.2, 1, 3>, <0.3, 1, 3>, <3.2, 1, -2> texture_list { T1, T2, T3 } } no_image }
