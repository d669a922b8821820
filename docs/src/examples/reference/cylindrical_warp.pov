cylinder { 0, 2.4*y, 1 pigment { checker srgb 1, srgb <0.6, 0.1, 0.1> scale 1/8 warp { cylindrical orientation y dist_exp 0 } scale <1, 4, 1> } }
