sphere {
  y, 1
  pigment {
    average
    pigment_map {
      [1 gradient y color_map { [0 srgb <0.8, 0.2, 0.1>] [1 srgb 1] } scale 0.4]
      [1 gradient x color_map { [0 srgb <0.1, 0.2, 0.8>] [1 srgb 1] } scale 0.4]
    }
  }
}
