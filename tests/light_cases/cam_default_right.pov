#version 3.7;
global_settings { assumed_gamma 1 }
// The brightness is where a ray hits the plane, so that it shows the width of the default `right`.
camera { location -4*z }
plane { z, 0 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 8 translate 4*x } finish { ambient 0 diffuse 0 emission 1 } }
