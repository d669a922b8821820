// Version 3.7 ignores `ambient` where radiosity is on, but not `emission`.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { recursion_limit 3 } }
camera { location 0 look_at z }
sphere { 0, 10 pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.7 emission 0.2 diffuse 0.5 } }
