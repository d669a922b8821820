box {
  -1, 1
  pigment {
    pigment_pattern { gradient x color_map { [0 rgb 0] [1 rgb 1] } }
    color_map { [0 srgb <0.8, 0.2, 0.1>] [1 srgb <1, 0.9, 0.6>] }
    scale 0.5
  }
  translate y rotate 25*y
}
