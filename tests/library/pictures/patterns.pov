// The patterns of functions.inc as functions, and eval_pigment.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "functions.inc"

camera { location <12, 10, -1002> right 28*x up 24*y direction 1000*z }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare Bands = color_map { [0 rgb <0.1, 0.3, 0.5>] [0.5 rgb <0.9, 0.9, 0.6>] [0.7 rgb <0.6, 0.1, 0.1>] [1 rgb 1] }
#declare Count = 0;
#macro Tile(Shown)
  box {
    -2, 2
    pigment { function { Shown(1.3*x + 0.11, 1.3*y + 0.17, z + 2.63) } color_map { Bands } }
    translate <4*mod(Count, 7), 20 - 4*int(Count/7), 0>
  }
  #declare Count = Count + 1;
#end
Tile(f_agate) Tile(f_boxed) Tile(f_bozo) Tile(f_brick) Tile(f_bumps) Tile(f_checker) Tile(f_crackle)
Tile(f_cylindrical) Tile(f_dents) Tile(f_gradientX) Tile(f_gradientY) Tile(f_gradientZ) Tile(f_granite)
Tile(f_leopard) Tile(f_mandel) Tile(f_marble) Tile(f_onion) Tile(f_planar) Tile(f_radial) Tile(f_ripples)
Tile(f_spherical) Tile(f_spiral1) Tile(f_spiral2) Tile(f_spotted) Tile(f_waves) Tile(f_wood) Tile(f_wrinkles)
#declare Stone = pigment { marble turbulence 0.5 color_map { [0 SkyBlue] [1 Scarlet] } }
#for (I, 0, 63)
  #local At = <mod(I, 8), int(I/8), 0>/2;
  box { At, At + 0.5 translate <22, -2, -0.5> pigment { eval_pigment(Stone, 3*At) } }
#end
