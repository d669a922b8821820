sphere { y, 1 pigment { srgb 0.3 } finish { irid { 0.5 thickness 0.4 turbulence 0.3 } specular 0.4 } }
