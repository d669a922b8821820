// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings { assumed_gamma 1 number_of_waves 25 }
camera { location <0, 0, -3> look_at 0 angle 67 }
plane { z, 0 pigment { ripples color_map { [0 rgb <0, 0, 1>] [1 rgb <1, 1, 0>] } } finish { ambient 1 diffuse 0 } }
