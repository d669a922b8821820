#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 20 subsurface { samples 3000, 300 } }
camera { orthographic location <0, 10, 0> direction -y right 2 * x up 1.5 * z }
light_source { <-1000000, -1000000, 0>, rgb <0.8, 1, 0.9> parallel point_at 0 }
light_source { <0, 5, 2>, rgb 0.5 }
box { <-20, -0.1, -20>, <20, 0, 20>
  pigment { rgb <0.8, 0.5, 0.1> } finish { ambient 0.1 diffuse 0.9 subsurface { translucency <3, 2, 1> } } interior { ior 1.5 }
}
