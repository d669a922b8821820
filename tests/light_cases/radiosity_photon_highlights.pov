// The highlight of photons on the floor does not light the ceiling.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 100 } photons { count 20000 } }
camera { location <0, 7, 0> look_at <0, 9, 0> right x up z sky z }
light_source { <0, 6, 0> rgb 4 spotlight point_at <0, 3, 0> radius 8 falloff 10 photons { reflection on } }
box { <-1.5, -0.02, -1.5>, <1.5, 0.02, 1.5> rotate -65*z translate <0, 3, 0> pigment { rgb 0 } finish { reflection 1 diffuse 0 ambient 0 } photons { target reflection on collect off } }
plane { y, 0 pigment { rgb 1 } finish { diffuse 0.0001 specular 3 roughness 0.3 ambient 0 } }
plane { y, 10 pigment { rgb 1 } finish { diffuse 0.6 ambient 0 } }
