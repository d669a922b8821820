// Behind its place each light of a grid of parallel spotlights is seen from its back.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 9, 0> direction -y right 8*x up 6*z }
plane { y, 1.9 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
light_source { <0.2, 2, 0.1> rgb 1 parallel spotlight radius 14 falloff 45 tightness 2 point_at 0 area_light x, 0.5*y, 3, 2 area_illumination }
