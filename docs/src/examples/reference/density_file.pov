box { 0, 1 pigment { density_file df3 "block.df3" interpolate 1 color_map { [0 srgb 1] [1 srgb <0.1, 0.3, 0.6>] } } scale 2 translate -x rotate 25*y }
