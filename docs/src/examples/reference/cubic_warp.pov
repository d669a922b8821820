box { -1, 1 pigment { checker srgb 1, srgb <0.1, 0.5, 0.2> scale 1/16 warp { cubic } } translate y rotate 25*y }
