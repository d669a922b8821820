// Meshes and blobs keep all light away where their outside would, also on their inside, which lets light pass on other shapes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -9> look_at 0 up 3*y right 4*x }
light_source { <.3, .2, -50> 1 parallel point_at 0 }
plane { -z, 0 pigment { rgb 1 } finish { ambient .1 diffuse .8 } no_shadow }
#declare Clear = texture { pigment { rgbt <1, .8, .6, .7> } }
mesh { triangle { <-2, .5, -1>, <-2, 1.4, -1>, <-1, .5, -1> } texture { pigment { rgb 1 } } interior_texture { Clear } no_image }
mesh { triangle { <-2, -.5, -1>, <-1, -.5, -1>, <-2, .4, -1> } texture { pigment { rgb 1 } } interior_texture { Clear } no_image }
mesh2 { vertex_vectors { 3, <-2, -1.4, -1>, <-2, -.6, -1>, <-1, -1.4, -1> } face_indices { 1, <0, 1, 2> } texture { pigment { rgb 1 } } interior_texture { Clear } no_image }
mesh { triangle { <-.5, .5, -1>, <-.5, 1.4, -1>, <.5, .5, -1> } texture { Clear } interior_texture { pigment { rgb 1 } } no_image }
disc { <.2, -.2, -1>, z, .4 texture { pigment { rgb 1 } } interior_texture { Clear } no_image }
disc { <.2, -1.1, -1>, -z, .3 texture { pigment { rgb 1 } } interior_texture { Clear } no_image }
difference { blob { threshold .5 sphere { <1.3, .8, -1>, 1, 1 } } box { <0, 0, -1.05>, <2, 2, -9> } texture { pigment { rgb 1 } } interior_texture { Clear } no_image }
difference { sphere { <1.3, -.8, -1>, .6 } box { <0, 0, -1.05>, <2, -2, -9> } texture { pigment { rgb 1 } } interior_texture { Clear } no_image }
