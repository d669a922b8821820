// A pigment with a `uv_mapping` of its own is something everywhere, also outside of a picture that is there `once`: `conserve_energy` takes
// from what passes. In a texture with `uv_mapping` it is nothing there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 60 }
background { rgb <.1, .3, .5> }
#default { finish { ambient 1 diffuse 0 reflection .3 conserve_energy } }
#declare Once = pigment { image_map { function 3, 6 { x } once } }
sphere { 0, .7 texture { pigment { uv_mapping image_map { function 3, 6 { x } once } scale .5 } } translate <-1.5, .8, 4> }
sphere { 0, .7 texture { pigment { gradient y pigment_map { [.5 uv_mapping image_map { function 3, 6 { x } once } scale .5] [.8 rgb .5] } } } translate <0, .8, 4> }
sphere { 0, .7 texture { pigment { uv_mapping gradient y pigment_map { [.5 Once scale .5] [.8 rgb .5] } } } translate <1.5, .8, 4> }
sphere { 0, .7 texture { uv_mapping pigment { gradient y pigment_map { [.5 Once scale .5] [.8 rgb .5] } } } translate <-1.5, -.8, 4> }
sphere { 0, .7 texture { uv_mapping pigment { gradient y pigment_map { [.5 uv_mapping image_map { function 3, 6 { x } once } scale .5] [.8 rgb .5] } } } translate <0, -.8, 4> }
sphere { 0, .7 uv_mapping texture { pigment { gradient y pigment_map { [.5 Once scale .5] [.8 rgb .5] } } } translate <1.5, -.8, 4> }
