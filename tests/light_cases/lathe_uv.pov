#version 3.7;
global_settings { assumed_gamma 1 }
// Segments of different lengths count alike in v.
camera { location <0, 1.1, -4.3> look_at .85*y angle 45 }
#declare Show = texture { uv_mapping pigment { gradient y color_map { [0 rgb 0] [1 rgb <1, .5, .2>] } } finish { ambient 0 diffuse 0 emission 1 } }
lathe { linear_spline 4, <.2, 0>, <.8, .2>, <.5, 1.6>, <.3, 1.8> texture { Show } translate -.9*x }
sor { 5, <.2, -.3>, <.6, 0>, <.7, .3>, <.3, 1.4>, <.2, 1.8> texture { Show } translate .9*x }
