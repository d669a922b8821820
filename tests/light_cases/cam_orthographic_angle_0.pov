// `angle 0` makes the window of an orthographic camera as large as that of a perspective camera at `look_at`.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Lit = finish { ambient 1 diffuse 0 }
plane { z, 30 pigment { checker rgb <1, 0.2, 0.1> rgb <0.1, 0.4, 1> scale 2 } finish { Lit } }
plane { y, -9 pigment { checker rgb <1, 1, 0.1> rgb <0.1, 1, 1> scale 2 } finish { Lit } }
plane { -y, -19 pigment { checker rgb <0.3, 1, 0.1> rgb <0.5, 0.3, 0.6> scale 3 } finish { Lit } }
plane { x, 14 pigment { checker rgb <0.3, 0.1, 0.1> rgb <0.1, 0.8, 0.6> scale 3 } finish { Lit } }
plane { x, -14 pigment { gradient y color_map { [0 rgb <1, 0.3, 1>] [1 rgb <0.2, 0.7, 0.1>] } scale 6 } finish { Lit } }
camera { orthographic angle 0 location <3, 0, -6> look_at 0 right x*3 up y*2 }
