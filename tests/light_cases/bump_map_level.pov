// The directions of a `bump_map` on what lies level in its space, but for the last digits, which rotating back leaves.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <1.815, 2.892, -5.356> look_at <0.285, 0.2, -0.29> right 4*x up 3*y }
light_source { <3.443, 3.779, -7.546> 1 }
box { -1, 1 pigment { rgb 1 } normal { bump_map { function 3, 3 { x } map_type 2 interpolate 3 bump_size 1.948 } scale 1.769 } finish { diffuse 1 } rotate <50, -20, 130> }
