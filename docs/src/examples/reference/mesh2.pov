// An octahedron by numbers into lists; colours run from corner to corner
mesh2 {
  vertex_vectors { 6, <1, 0, 0>, <0, 0, 1>, <-1, 0, 0>, <0, 0, -1>, <0, 1, 0>, <0, -1, 0> }
  texture_list {
    3, texture { pigment { srgb <0.9, 0.3, 0.2> } } texture { pigment { srgb <0.2, 0.5, 0.9> } } texture { pigment { srgb <0.95, 0.85, 0.3> } }
  }
  face_indices {
    8, <0, 1, 4>, 0, 1, 2, <1, 2, 4>, 1, 0, 2, <2, 3, 4>, 0, 1, 2, <3, 0, 4>, 1, 0, 2,
    <0, 1, 5>, 0, 1, 2, <1, 2, 5>, 1, 0, 2, <2, 3, 5>, 0, 1, 2, <3, 0, 5>, 1, 0, 2
  }
  rotate y*25 translate y
}
