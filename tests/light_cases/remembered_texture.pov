// Which textures make a group the object that POV-Ray remembers when it keeps light away: what lets nothing pass, but not if a pattern
// chooses among textures. What is remembered is twice as dark to the right of its opaque end.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <8, 10, 6> direction -y right 16*x up 12*z }
light_source { <8, 1000, 6> 1 parallel point_at <8, 0, 6> }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare Clear = pigment { rgb 1 transmit 0.5 }
#macro Part(Left, Z)
  box { <Left, 1, Z + 0.1>, <Left + 4, 2, Z + 0.9> pigment { gradient x color_map { [0.25 rgb 1] [0.25 rgb 1 transmit 0.5] } scale 4 translate Left*x } }
  box { 30, 31 }
#end
difference { Part(0, 0) pigment { rgb 1 } no_image }
difference { Part(4, 0) texture { gradient x texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 1 }] } } no_image }
difference { Part(8, 0) texture { gradient x texture_map { [0 pigment { rgb 1 }] [1 pigment { Clear }] } } no_image }
difference { Part(12, 0) pigment { gradient x pigment_map { [0 rgb 1] [1 rgb 0.5] } } no_image }
difference { Part(0, 1) pigment { gradient x pigment_map { [0 rgb 1] [1 Clear] } } no_image }
difference { Part(4, 1) texture { checker texture { pigment { rgb 1 } }, texture { pigment { rgb 1 } } } no_image }
difference { Part(8, 1) texture { average texture_map { [1 pigment { rgb 1 }] [1 pigment { rgb 1 }] } } no_image }
difference { Part(12, 1) texture { material_map { function 2, 2 { 1 } texture { pigment { rgb 1 } } texture { pigment { rgb 1 } } } } no_image }
difference { Part(0, 2) texture { pigment { rgb 1 } } texture { pigment { Clear } } no_image }
difference { Part(4, 2) texture { pigment { Clear } } texture { pigment { rgb 1 } } no_image }
difference { Part(8, 2) texture { pigment { Clear } } texture { pigment { Clear } } no_image }
difference { Part(12, 2) texture { } no_image }
difference { Part(0, 3) pigment { checker rgb 1, rgb 0 } no_image }
difference { Part(4, 3) pigment { checker pigment { rgb 1 } pigment { rgb 0.5 } } no_image }
difference { Part(8, 3) pigment { checker pigment { rgb 1 } pigment { Clear } } no_image }
difference { Part(12, 3) pigment { average pigment_map { [1 rgb 1] [1 rgb 0.5] } } no_image }
difference { Part(0, 4) pigment { image_map { function 3, 3 { 1 } } } no_image }
difference { Part(4, 4) pigment { image_map { function 3, 3 { 1 } transmit all 0.3 } } no_image }
difference { Part(8, 4) pigment { gradient x } no_image }
difference { Part(12, 4) pigment { gradient x color_map { [0 rgb 1] [1 rgb 0.5 filter 0.1] } } no_image }
difference { Part(0, 5) texture { } interior_texture { pigment { Clear } } no_image }
difference { Part(4, 5) texture { } interior_texture { pigment { rgb 1 } } no_image }
merge { Part(8, 5) material { texture { pigment { rgb 1 } } interior { ior 1 } } no_image }
union { difference { Part(12, 5) } pigment { rgb 1 } no_image }
#default { pigment { rgb 1 } }
difference { Part(0, 6) no_image }
#default { pigment { Clear } }
difference { Part(4, 6) normal { bumps } no_image }
difference { Part(8, 6) finish { phong 1 } no_image }
// Of lights of a group nothing is remembered, but what keeps others away from it.
light_group {
  light_source { <8, 1000, 6> rgb <1, 0, 0.5> parallel point_at <8, 0, 6> }
  box { <0, 0, 9>, <16, 0.5, 12> pigment { rgb 1 } finish { ambient 0 diffuse 0.5 } no_shadow }
  difference { Part(0, 9) pigment { rgb 1 } no_image }
  global_lights on
}
difference { Part(6, 9) pigment { rgb 1 } no_image }
difference { Part(10, 10) pigment { rgb 1 } no_image }
// Shapes that carry textures themselves.
#default { pigment { rgb 1 } finish { ambient 0.1 } }
mesh2 {
  vertex_vectors { 6, <0, 1, 7.1>, <2, 1, 7.1>, <0, 1, 8.9>, <2, 1, 8.9>, <4, 1, 7.1>, <4, 1, 8.9> }
  texture_list { 2, texture { pigment { rgb 1 } } texture { pigment { Clear } } }
  face_indices { 4, <0, 1, 2>, 0, <1, 2, 3>, 0, <1, 3, 4>, 1, <3, 4, 5>, 1 }
  pigment { rgb 1 } no_image
}
mesh2 {
  vertex_vectors { 6, <4, 1, 7.1>, <6, 1, 7.1>, <4, 1, 8.9>, <6, 1, 8.9>, <8, 1, 7.1>, <8, 1, 8.9> }
  texture_list { 2, texture { pigment { rgb 1 } } texture { pigment { Clear } } }
  face_indices { 4, <0, 1, 2>, 0, <1, 2, 3>, 0, <1, 3, 4>, 1, <3, 4, 5>, 1 }
  pigment { Clear } no_image
}
blob { threshold 0.5 sphere { <9.5, 1, 8>, 2, 1 pigment { rgb 1 } } sphere { <11.5, 1, 8>, 2, 1 pigment { Clear } } pigment { rgb 1 } no_image }
blob { threshold 0.5 sphere { <13.5, 1, 8>, 2, 1 pigment { rgb 1 } } sphere { <15.5, 1, 8>, 2, 1 pigment { Clear } } pigment { Clear } no_image }
