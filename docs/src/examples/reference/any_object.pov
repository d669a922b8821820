difference {
  sphere { y, 1 }
  box { <-0.4, 0, -2>, <0.4, 2, 2> inverse no_shadow }
  clipped_by { plane { y, 1.6 } }
  pigment { srgb <0.85, 0.45, 0.2> }
  interior_texture { pigment { srgb <0.3, 0.2, 0.6> } }
}
