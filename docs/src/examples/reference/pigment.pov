sphere { <-1.1, 1, 0>, 1 pigment { srgb <0.8, 0.3, 0.2> } }
sphere { <1.1, 1, 0>, 1 pigment { gradient y color_map { [0 srgb <0.8, 0.3, 0.2>] [1 srgb <1, 0.9, 0.5>] } scale 0.5 } }
