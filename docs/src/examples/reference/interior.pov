sphere { y, 1 pigment { srgbt <0.9, 1, 0.9, 0.9> } finish { specular 0.6 } interior { ior 1.5 fade_distance 1 fade_power 2 } }
