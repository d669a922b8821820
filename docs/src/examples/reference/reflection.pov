sphere { <-1.1, 1, 0>, 1 pigment { srgb <0.9, 0.7, 0.3> } finish { diffuse 0.2 reflection { 0.7 metallic } } }
sphere { <1.1, 1, 0>, 1 pigment { srgb 0.1 } finish { reflection { 0.02, 0.9 fresnel on } } interior { ior 1.5 } }
