box { <-2, 0, 0>, <2, 3, 0.2> pigment { checker srgb 1, srgb <0.2, 0.3, 0.6> scale 1/2 warp { planar z, 0 } } rotate 25*y }
