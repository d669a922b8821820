box {
  0, 1
  texture {
    material_map {
      png "tile.png"
      texture { pigment { srgb <0.9, 0.85, 0.7> } }
      texture { pigment { srgb <0.2, 0.35, 0.6> } finish { specular 0.5 } }
      texture { pigment { srgb 0.2 } finish { reflection 0.4 } }
      texture { pigment { srgb <0.8, 0.2, 0.1> } }
    }
  }
  scale 2 translate -x rotate 25*y
}
