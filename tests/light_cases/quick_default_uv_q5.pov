#version 3.7; global_settings { assumed_gamma 1 }
// A default's `quick_color` hides what `uv_mapping` says of the surface, unless the default is mapped by uv too.
camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
#default { pigment { uv_mapping rgb <1,.1,.2> quick_color rgb <.1,.5,.3> } finish { ambient 1 } }
sphere { -x, 1 pigment { uv_mapping rgb <.1,.2,.8> } }
#default { pigment { rgb <1,.1,.2> quick_color rgb <.1,.5,.3> } finish { ambient 1 } }
sphere { x, 1 pigment { uv_mapping rgb <.1,.2,.8> } }
