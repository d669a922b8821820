sphere { y, 1 pigment { srgbt <0.9, 1, 0.9, 0.9> } interior { ior 1.5 } photons { target refraction on reflection on } }
