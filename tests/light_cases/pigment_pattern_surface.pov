// `pigment_pattern` asks its pigment about the surface: how it is turned (not by bumps that it makes itself), where it lies on its shape,
// with as many waves as the scene has.
#version 3.7;
global_settings { assumed_gamma 1 number_of_waves 3 }
camera { location 0 look_at z angle 60 }
light_source { <1, 3, -1> rgb 1 }
#default { finish { ambient 1 diffuse 0 } }
sphere { <-1.5, .8, 4>, .7 pigment { pigment_pattern { slope y color_map { [0 rgb 0] [1 rgb 1] } } color_map { [0 rgb 0] [1 rgb 1] } } }
sphere { <0, .8, 4>, .7 pigment { pigment_pattern { aoi color_map { [0 rgb 0] [1 rgb 1] } rotate 40*x } color_map { [0 rgb 0] [1 rgb 1] } } normal { bumps 1 scale .3 } }
sphere { 0, .7 pigment { pigment_pattern { uv_mapping gradient y color_map { [0 rgb 0] [1 rgb 1] } scale .4 } color_map { [0 rgb 0] [1 rgb 1] } } translate <1.5, .8, 4> }
sphere { 0, .7 pigment { pigment_pattern { uv_mapping image_map { function 4, 4 { x } once } scale .7 } color_map { [0 rgb 0] [1 rgb 1] } } rotate 150*y translate <-1.5, -.8, 4> }
sphere { 0, .7 pigment { pigment_pattern { ripples color_map { [0 rgb 0] [1 rgb 1] } scale .3 } color_map { [0 rgb 0] [1 rgb 1] } } translate <0, -.8, 4> }
sphere { 0, .7 pigment { rgb 1 } finish { ambient 0 diffuse 1 } normal { pigment_pattern { gradient x pigment_map { [.4 uv_mapping gradient y color_map { [0 rgb 0] [1 rgb 1] }] [.6 slope x color_map { [0 rgb 0] [1 rgb 1] }] } scale .3 } 1 } translate <1.5, -.8, 4> }
