torus { 1.4, 0.6 pigment { checker srgb 1, srgb <0.6, 0.1, 0.1> scale 1/8 warp { toroidal orientation y major_radius 1.4 } } rotate -30*x translate y }
