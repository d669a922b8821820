// Before 3.5 each word of a camera takes effect where it is written.
#version 3.1;
global_settings { assumed_gamma 1 }
#declare Lit = finish { ambient 1 diffuse 0 }
plane { z, 30 pigment { checker rgb <1, 0.2, 0.1> rgb <0.1, 0.4, 1> scale 2 } finish { Lit } }
plane { y, -9 pigment { checker rgb <1, 1, 0.1> rgb <0.1, 1, 1> scale 2 } finish { Lit } }
plane { -y, -19 pigment { checker rgb <0.3, 1, 0.1> rgb <0.5, 0.3, 0.6> scale 3 } finish { Lit } }
plane { x, 14 pigment { checker rgb <0.3, 0.1, 0.1> rgb <0.1, 0.8, 0.6> scale 3 } finish { Lit } }
plane { x, -14 pigment { gradient y color_map { [0 rgb <1, 0.3, 1>] [1 rgb <0.2, 0.7, 0.1>] } scale 6 } finish { Lit } }
camera { look_at <1, 0, 3> location <1, 2, -8> sky <1, 3, 0> rotate <5, 10, 0> angle 50 right <1.2, 0.1, 0> look_at <0, 1, 3> up <0, 0.8, 0.1> direction <0, 0.1, 0.8> translate <0, 1, 0> }
