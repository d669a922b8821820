#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <.6, 2.2, -6> look_at 0 angle 35 }
light_source { <5.7, 3.9, -6> 1 projected_through { sphere { <2, 2, -2>, .3 } } }
box { -1, 1 pigment { rgb <.9, .8, .3> } }
