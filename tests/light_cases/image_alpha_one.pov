#version 3.7; global_settings { assumed_gamma 1 }
// A picture whose alpha is 1 everywhere casts a whole shadow, also where it is not: at its own origin, which triangles without `uv_vectors` show.
camera { location <1.2,1,-5> look_at 0 angle 50 }
light_source { <1.491, 2.222, -6.667> srgb <0.037, 0.463, 0.966> }
plane { -z, -4 pigment { checker rgb 1 rgb 0 } }
mesh { triangle { -x, x, y } pigment { uv_mapping image_map { function 4, 3 { sin(x*9)*0.5 + 0.5 } map_type 1 } } }
mesh { triangle { -x, x, y } pigment { uv_mapping image_map { function 4, 3 { pigment { bozo color_map { [0 rgbt .5][1 rgbf .7] } } } map_type 1 } } translate -1.2*y }
