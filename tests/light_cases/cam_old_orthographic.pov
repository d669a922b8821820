// Before 3.5 `orthographic` sizes the window by the words before it.
#version 3.1;
global_settings { assumed_gamma 1 }
#declare Lit = finish { ambient 1 diffuse 0 }
plane { z, 30 pigment { gradient <1, 0.6, 0> color_map { [0 rgb <1, 0.2, 0.1>] [1 rgb <0.1, 0.4, 1>] } scale 6 } finish { Lit } }
plane { y, -9 pigment { checker rgb <1, 1, 0.1> rgb <0.1, 1, 1> scale 2 } finish { Lit } }
plane { -y, -19 pigment { checker rgb <0.3, 1, 0.1> rgb <0.5, 0.3, 0.6> scale 3 } finish { Lit } }
plane { x, 14 pigment { checker rgb <0.3, 0.1, 0.1> rgb <0.1, 0.8, 0.6> scale 3 } finish { Lit } }
plane { x, -14 pigment { gradient y color_map { [0 rgb <1, 0.3, 1>] [1 rgb <0.2, 0.7, 0.1>] } scale 6 } finish { Lit } }
camera { location <3, 2, -5> angle 70 look_at <0, 1, 2> orthographic up 3*y rotate <0, 0, 10> direction 2*z sky x }
