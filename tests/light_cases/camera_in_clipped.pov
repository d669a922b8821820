#version 3.7; global_settings { assumed_gamma 1 }
// What clips an object does not ask where the camera starts, its box does: this one starts in the first, not in the second.
camera { location -4*z look_at 0 }
plane { z, 6 hollow pigment { gradient x + y color_map { [0 rgb 1] [1 rgb <0, 0.3, 0.6>] } scale 9 } finish { ambient 1 diffuse 0 } }
sphere { -x, 0.9 pigment { rgbt <1, 0.8, 0.7, 0.8> } finish { ambient 0 diffuse 0 } }
sphere { <1, 0.3, 0>, 0.9 pigment { rgbt <0.7, 0.8, 1, 0.8> } finish { ambient 0 diffuse 0 } interior { ior 1.2 } }
sphere { 0, 8 clipped_by { sphere { <2, 2, -2>, 2.5 } } pigment { rgbt 1 } interior { ior 1.3 fade_distance 9 fade_power 2 fade_color rgb <1, 0.4, 0.2> } }
sphere { 0, 8 clipped_by { sphere { 0, 2 } } pigment { rgbt 1 } interior { ior 1.9 } }
