// A grid is one light below quality 5; without shadows it shines on both sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at 0 }
#default { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
sphere { <0, 1, 0>, 1.6 }
plane { y, 0 }
light_source { <2, 5, -3> rgb 1 area_light x*5, y*5, 5, 2 area_illumination }
