// What is oriented is round whether it is circular or not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 9, 0> direction -y right 3*x up 3*z }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } no_shadow }
sphere { <0, 0.7, 0>, 0.4 no_image }
light_source { <0.4, 5, 0.2> rgb 1 area_light x, 2*z, 2, 5 orient }
