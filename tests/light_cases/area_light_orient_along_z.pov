// An oriented grid is level about y where its light goes nearly along z, and about z elsewhere: the pattern of its lights turns.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <1.45, 0, -1> direction z right 4*x up 3*y }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } no_shadow }
cylinder { <1.1, -2, -2.5>, <1.1, 2, -2.5>, 0.2 no_image }
cylinder { <0, 0.3, -2>, <5, 0.3, -2>, 0.1 no_image }
light_source { <0, 0, -10> rgb 1 area_light 2*x, 2*y, 2, 5 orient }
