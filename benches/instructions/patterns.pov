// Patterns made of noise, on one plane each.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4 * x up 3 * y }
light_source { <3, 4, -9> rgb 1 }
#macro Tile(N, P) box { 0, 1 pigment { P scale 0.2 } normal { bumps 0.1 scale 0.1 } translate <mod(N, 4) - 2, floor(N / 4) - 1.5, 0> } #end
#local C = color_map { [0 rgb <0.2, 0.1, 0.4>] [0.5 rgb <0.9, 0.6, 0.2>] [1 rgb 1] };
Tile(0, pigment { bozo color_map { C } })
Tile(1, pigment { granite color_map { C } })
Tile(2, pigment { marble turbulence 0.8 color_map { C } })
Tile(3, pigment { wood turbulence <0.1, 0.2, 0> color_map { C } })
Tile(4, pigment { agate color_map { C } })
Tile(5, pigment { wrinkles color_map { C } })
Tile(6, pigment { crackle color_map { C } })
Tile(7, pigment { dents warp { turbulence 0.5 octaves 4 } color_map { C } })
Tile(8, pigment { ripples color_map { C } })
Tile(9, pigment { spotted color_map { C } })
Tile(10, pigment { leopard turbulence 0.3 color_map { C } })
Tile(11, pigment { mandel 50 color_map { C } })
