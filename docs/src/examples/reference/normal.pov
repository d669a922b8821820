sphere { y, 1 pigment { srgb <0.8, 0.5, 0.3> } normal { dents 1.5 scale 0.2 } finish { specular 0.6 } }
