// A smooth mesh of 3200 triangles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at 0 angle 45 }
light_source { <5, 8, -6> rgb 1 }
#declare N = 40;
#macro Height(X, Z) (0.3 * sin(3 * X) * cos(2 * Z)) #end
mesh2 {
  vertex_vectors { (N + 1) * (N + 1) #for (I, 0, N) #for (J, 0, N) , <4 * I / N - 2, Height(4 * I / N - 2, 4 * J / N - 2), 4 * J / N - 2> #end #end }
  normal_vectors { (N + 1) * (N + 1) #for (I, 0, N) #for (J, 0, N) , <-0.9 * cos(3 * (4 * I / N - 2)) * cos(2 * (4 * J / N - 2)), 1, 0.6 * sin(3 * (4 * I / N - 2)) * sin(2 * (4 * J / N - 2))> #end #end }
  face_indices { 2 * N * N #for (I, 0, N - 1) #for (J, 0, N - 1) #local A = I * (N + 1) + J; , <A, A + 1, A + N + 1>, <A + 1, A + N + 2, A + N + 1> #end #end }
  pigment { rgb <0.5, 0.7, 0.4> } finish { phong 0.4 }
}
