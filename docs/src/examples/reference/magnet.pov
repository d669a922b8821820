box { <-2, 0, -0.1>, <2, 3, 0> pigment { magnet 1 mandel 30 color_map { [0 srgb 0] [0.2 srgb <0.2, 0.3, 0.7>] [0.6 srgb <1, 0.8, 0.4>] [1 srgb 1] } translate 1.5*y } }
