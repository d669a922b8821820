// How far the light of a grid comes is how far its place lies in the direction it shines from; behind it too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 9, 0> direction -y right 4*x up 3*z }
plane { y, 1.9 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
light_source { <0, 2, 0> rgb 0.5 parallel point_at <0.5, 0.3, 0.2> area_light x, 0.5*y + z, 3, 2 area_illumination fade_distance 2 fade_power 1 }
