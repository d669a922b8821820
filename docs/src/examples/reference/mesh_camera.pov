#version 3.7;
global_settings { assumed_gamma 1 }
// A quarter of a tube that looks outwards: uv across the picture.
#declare Sides = 24;
#declare Tube = mesh2 {
  vertex_vectors { 2*Sides + 2
    #for (I, 0, Sides) , vrotate(-z/2, (I/Sides*180 - 90)*y), vrotate(-z/2, (I/Sides*180 - 90)*y) + 2.4*y #end
  }
  uv_vectors { 2*Sides + 2 #for (I, 0, Sides) , <I/Sides, 0>, <I/Sides, 1> #end }
  face_indices { 2*Sides
    #for (I, 0, Sides - 1) , <2*I, 2*I + 1, 2*I + 2>, <2*I + 1, 2*I + 3, 2*I + 2> #end
  }
}
camera { mesh_camera { 1 3 mesh { Tube rotate 180*y } } }
light_source { <-6, 9, -4> rgb 1 }
background { srgb <0.72, 0.82, 0.92> }
plane { y, 0 pigment { checker srgb 0.85, srgb 0.6 } }
#for (I, 0, 11)
  cylinder { <0, 0, 5>, <0, 0.8 + I/10, 5>, 0.35 pigment { srgb <0.8, 0.2 + I/20, 0.1> } rotate I*30*y }
#end
