box { 0, 1 pigment { image_pattern { png "tile.png" } color_map { [0 srgb <0.2, 0.1, 0.4>] [1 srgb <1, 0.9, 0.5>] } } scale 2 translate -x rotate 25*y }
