// A roof of four triangles, each side with a texture of its own
#declare Tiles = texture { pigment { brick srgb <0.5, 0.2, 0.15>, srgb <0.75, 0.35, 0.25> brick_size <0.3, 0.15, 0.3> mortar 0.02 } };
#declare Straw = texture { pigment { wood color_map { [0 srgb <0.8, 0.65, 0.3>] [1 srgb <0.6, 0.45, 0.2>] } scale <0.02, 1, 0.02> } };
mesh {
  triangle { <-1, 0, -1>, <1, 0, -1>, <0, 1.6, 0> texture { Tiles } }
  triangle { <1, 0, -1>, <1, 0, 1>, <0, 1.6, 0> texture { Straw } }
  triangle { <1, 0, 1>, <-1, 0, 1>, <0, 1.6, 0> texture { Tiles } }
  triangle { <-1, 0, 1>, <-1, 0, -1>, <0, 1.6, 0> texture { Straw } }
  inside_vector y
  rotate y*35
}
