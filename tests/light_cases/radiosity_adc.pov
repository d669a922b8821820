// Bounces end where the product of the diffuse shares is at most 0.01.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { recursion_limit 20 } }
camera { location 0 look_at z }
sphere { 0, 10 pigment { rgb 1 } finish { emission 0.2 diffuse 0.5 } }
