// povray +W16 +H12 -A File_Gamma=1.0 +FP16
// Everything is inside of what nothing shares: the camera starts in it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1.02, 0.417, -6> look_at <0.192, -0.213, 0.112> angle 38.362 }
sphere { 0, 1 pigment { gradient x color_map { [0.5 rgbt <1, 0, 0, 0.7>] [0.5 rgbt <0, 0, 1, 0.8>] } scale 0.2 } }
plane { -z, -3 pigment { checker rgb 0.9 rgb 0.3 } finish { ambient 1 diffuse 0 } }
union { intersection { interior { ior 1.3 } translate 100 } box { 5, 6 } }
difference { interior { ior 1.2 } clipped_by { sphere { 100, 20 } } }
