// Area lights, spotlights and a blurred camera.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0 angle 45 }
light_source { <5, 8, -6> rgb 0.8 area_light 3 * x, 3 * z, 7, 7 adaptive 1 circular orient }
light_source { <-6, 6, -3> rgb 0.5 spotlight point_at 0 radius 12 falloff 20 }
plane { y, -1 pigment { rgb 0.9 } }
#for (I, 0, 11)
  sphere { <3 * cos(I * pi / 6), -0.5, 3 * sin(I * pi / 6)>, 0.5 pigment { rgb <0.9, 0.4, 0.2> } }
#end
box { -0.7, 0.7 pigment { rgb <0.3, 0.5, 0.9> } finish { specular 0.4 } }
