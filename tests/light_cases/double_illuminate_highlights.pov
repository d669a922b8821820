// What is lit on both sides has highlights on both, wherever the half-way vector or the mirrored ray lies before it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -4*z right 4.4*x up 3.3*y }
light_source { <5, 2, 1> 1 parallel point_at 0 }
sphere { 0, 0.7 pigment { rgbf <0.3, 0.5, 0.7, 0.8> } finish { ambient 0 diffuse 0 specular 0.5 roughness 1 } double_illuminate translate <-1.4, 0.8, 0> }
sphere { 0, 0.7 pigment { rgbf <0.3, 0.5, 0.7, 0.8> } finish { ambient 0 diffuse 0.2 specular 0.5 roughness 0.3 metallic } double_illuminate translate <0, 0.8, 2> }
sphere { 0, 0.7 pigment { rgbf <0.3, 0.5, 0.7, 0.8> } finish { ambient 0 diffuse 0 phong 0.5 phong_size 1 } double_illuminate translate <1.4, 0.8, 4> }
sphere { 0, 0.7 pigment { rgbf <0.3, 0.5, 0.7, 0.8> } finish { ambient 0 diffuse 0 phong 0.5 phong_size 2 metallic 0.6 } double_illuminate translate <-1.4, -0.8, 0> }
sphere { <0, -0.8, 2>, 0.7 pigment { rgbf <0.3, 0.5, 0.7, 0.8> } finish { ambient 0 diffuse 0, 0.3 specular 0.5 roughness 1 } }
disc { <1.4, -0.8, 4>, <-0.2, 0.1, 1>, 0.7 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.2 specular 0.5 roughness 1 } double_illuminate }
