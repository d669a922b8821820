// A small sphere hides the centre of the area light, and gathered light counts this one point only: floor and wall do not
// light each other.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 20 } }
camera { location <0, 1, -3> look_at y angle 60 right x up y }
light_source { <0, 5, 0> rgb 1 area_light x*4, z*4, 5, 5 }
sphere { <0, 4.9, 0>, 0.15 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.5 } }
plane { -z, -2 pigment { rgb 1 } finish { ambient 0 diffuse 0.5 } }
