#version 3.7;
global_settings { assumed_gamma 1 }
// A curved sheet that looks at the scene, by its uv.
#declare Sheet = mesh2 {
    vertex_vectors { 35 #for (J, 0, 4) #for (I, 0, 6) , <-3 + I, 2 - J, -5 + .1*sin(I + J)> #end #end }
    normal_vectors { 35 #for (J, 0, 4) #for (I, 0, 6) , <(I - 3)/20, (2 - J)/20, 1> #end #end }
    uv_vectors { 35 #for (J, 0, 4) #for (I, 0, 6) , <I/6, 1 - J/4> #end #end }
    face_indices { 48 #for (J, 0, 3) #for (I, 0, 5) , <J*7 + I, J*7 + I + 1, J*7 + I + 7>, <J*7 + I + 8, J*7 + I + 7, J*7 + I + 1> #end #end }
}
camera { mesh_camera { 1 3 mesh { Sheet rotate 5*y } smooth } location -.2*z }
light_source { <2, 4, -6> 1 }
sphere { 0, 1.5 pigment { gradient y scale 4 translate 2*y } }
plane { z, 3 pigment { gradient x scale 20 translate 10*x } }
