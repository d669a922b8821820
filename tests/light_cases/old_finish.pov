// refraction, ior and caustics in the finish, as before 3.1: the topmost layer's count, before the interior's; refraction not for shadows
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -4> look_at <0, 0.9, 0> angle 60 }
light_source { <0, 10, -1>, 1 }
plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } }
plane { z, 6 pigment { gradient y color_map { [0 rgb 0.1] [1 rgb 0.4] } scale 3 } finish { ambient 1 diffuse 0 } }
sphere { <-1.6, 1.2, 1>, 0.6 texture { pigment { rgbf <1, 0.6, 0.5, 0.9> } finish { ambient 0 diffuse 0 refraction 0.6 caustics 20 } } }
sphere { <0, 1.2, 1>, 0.6 texture { pigment { rgbf <1, 0.6, 0.5, 0.9> } finish { ambient 0 diffuse 0 ior 1.4 refraction 1.2 } } interior { ior 1.1 caustics 0.4 } }
sphere { <1.6, 1.2, 1>, 0.6
  texture { pigment { rgbf <1, 0.8, 0.5, 0.9> } finish { ambient 0 diffuse 0 ior 1.5 refraction 0.1 caustics 9 } }
  texture { pigment { rgbf <0.9, 1, 1, 0.8> } finish { ambient 0 diffuse 0 refraction 0.8 } }
}
