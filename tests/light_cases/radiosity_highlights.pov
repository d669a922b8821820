// The highlight on the ceiling does not light the floor.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 100 } }
camera { location <0, 0.5, 0> look_at 0 right x up z sky z }
light_source { <0, 5, 0> rgb 1 }
plane { y, 0 pigment { rgb 1 } finish { diffuse 0.6 ambient 0 } }
plane { y, 10 pigment { rgb 1 } finish { diffuse 0 phong 1 phong_size 1 } }
