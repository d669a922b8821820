sphere {
  y, 1
  texture { pigment { srgb <0.2, 0.4, 0.2> } finish { specular 0.5 } }
  texture { pigment { bozo color_map { [0.45 srgbt <1, 0.9, 0.6, 0>] [0.55 srgbt 1] } scale 0.4 } }
}
