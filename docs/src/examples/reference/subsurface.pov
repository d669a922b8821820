global_settings { mm_per_unit 20 subsurface { samples 40, 10 } }
sphere { y, 1
  pigment { rgb <0.9, 0.7, 0.5> }
  finish { diffuse 0.9 specular 0.4 subsurface { translucency <4, 3, 2> } }
  interior { ior 1.4 }
}
