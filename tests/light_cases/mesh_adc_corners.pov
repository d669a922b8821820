#version 3.7; global_settings { assumed_gamma 1 adc_bailout .1 }
// What is less than adc_bailout of a triangle's texture is not seen: of each corner by itself, also where all three look the same.
camera { location -5*z look_at 0 angle 40 }
#default { finish { ambient 1 diffuse 0 } }
#declare A = texture { pigment { rgb <1,.5,.2> } };
mesh { triangle { <-1.5,0,0>, <0,0,0>, <-1,1.2,0> texture_list { A, A, A } } triangle { <1.5,0,0>, <0,0,0>, <1,1.2,0> texture { A } } }
mesh2 { vertex_vectors { 4, <-1.5,-1.2,0>, <1.5,-1.2,0>, <0,0,0>, <1.5,0,0> } texture_list { 2, texture { A } texture { pigment { rgb z } } }
  face_indices { 2, <0,1,2>, 0,0,0, <1,2,3>, 0 } }
