// `conserve_energy` takes nothing from what passes where a picture that is there `once` shows nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 80 }
light_source { <1, 3, -1> rgb 1 }
background { rgb <.1, .3, .5> }
plane { -z, -4 pigment { checker rgb 1 rgb <1, .5, 0> } finish { ambient .8 diffuse 0 } }
#declare Mirror = finish { ambient .1 diffuse .5 reflection { .1, .6 } conserve_energy }
#declare Once = pigment { image_map { function 3, 3 { x } once } }
box { <-2, .2, 2>, <2, 2, 2.1> texture { pigment { Once } finish { Mirror } } rotate 30*y }
box { <-2, -2, 2>, <-.1, 0, 2.1> texture { pigment { checker pigment { Once } pigment { average pigment_map { [1 Once translate 9] [0 rgb 1] } } scale .7 } finish { Mirror } } rotate -20*y }
box { <.1, -2, 2>, <2, 0, 2.1> texture { pigment { gradient y pigment_map { [.2 rgbt 1] [.6 Once translate 9] } } finish { Mirror } } texture { pigment { rgbt .7 } } rotate 20*x }
