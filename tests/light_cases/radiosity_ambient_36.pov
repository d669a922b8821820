// Versions before 3.7 keep `ambient` beside radiosity: inside a sphere, 0.2 + 0.5·(0.2 + 0.5·0.2).
#version 3.6;
global_settings { assumed_gamma 1 radiosity { recursion_limit 2 } }
camera { location 0 look_at z }
sphere { 0, 10 pigment { rgb 1 } finish { ambient 0.2 diffuse 0.5 } }
