// Fog takes its share of the whole way from a light, also of what lies between it and the thing that it is projected through.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 2, 0> look_at 0 right 4*x up 3*z sky z }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
fog { distance 10 rgb <0.1, 0.2, 0.3> }
light_source { <1, 7, 0> rgb 1 projected_through { disc { <-1, 3, 0>, y, 1 } } media_attenuation on }
light_source { <0, 6, 1> rgb <1, 0.5, 0.2> parallel point_at <0, 0, 1> projected_through { box { <0.5, 2, -1>, <1.5, 4, 1> } } media_attenuation on }
light_source { <0, 6, 1> rgb <0, 0.5, 0.2> projected_through { box { <-0.5, 2, -1>, <0.5, 4, 1> } } }
