box { 0, 1 pigment { image_map { png "tile.png" interpolate 2 } } scale 2 translate -x rotate 25*y }
