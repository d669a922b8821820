// The slope in an entry of a normal map sees what the entry before made of the normal; the upper of two goes first.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <3, 5, -6> rgb 1 parallel point_at 0 }
#default { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare Steep = normal { slope y normal_map { [0.5 bumps 0] [0.5 granite 2] } }
#macro Show(X, Y, Normal) sphere { <X - 1.5, Y - 1, 0>, 0.5 texture { normal { Normal } } } #end
Show(0, 0, normal { average normal_map { [1 bumps 3 scale 0.3] [1 Steep] } })
Show(1, 0, normal { average normal_map { [1 Steep] [1 bumps 3 scale 0.3] } })
Show(2, 0, normal { gradient y normal_map { [0 Steep] [1 bumps 3 scale 0.3] } })
Show(3, 0, normal { average normal_map { [0 bumps 3 scale <0.3, 0.1, 0.3> rotate 40] [1 Steep scale <1, 3, 1>] } })
Show(0, 1, normal { average normal_map { [1 bumps 3 no_bump_scale scale 0.3] [1 Steep no_bump_scale] } })
Show(1, 1, normal { average normal_map { [1 bumps 3 scale 0.3] [1 slope { y altitude x } 2] } })
#macro Textures(X, Y, Texture) sphere { <X - 1.5, Y - 1, 0>, 0.5 texture { Texture } } #end
Textures(2, 1, texture { average texture_map { [1 normal { bumps 3 scale 0.3 }] [1 slope y texture_map { [0.5 pigment { rgb 1 }] [0.5 pigment { rgb x }] }] } })
Textures(3, 1, texture { normal { bumps 3 scale 0.3 } } texture { pigment { rgb 1 transmit 0.5 } normal { Steep } })
#declare Rough = normal { crackle 0.6 accuracy 0.3 }
Show(0, 2, normal { Rough brick scale 0.1 })
Show(1, 2, normal { Rough checker scale 0.2 })
Show(2, 2, normal { Rough crackle scale 0.3 })
Show(3, 2, normal { slope { y altitude 0 } 2 })
