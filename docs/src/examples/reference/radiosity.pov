sphere { y, 1 pigment { srgb <0.8, 0.5, 0.2> } radiosity { importance 0.5 } }
