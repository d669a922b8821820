#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 8, 0> look_at <0, 0, 10> angle 40 }
light_source { <0, 0, -10> rgb 1 media_attenuation on }
light_source { <-5, 0, -4> rgb <1, 0.5, 0> media_attenuation on }
box { <-3, -99, -7>, <9, 99, -2> pigment { rgbt <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0 } }
box { <-20, -99, 5>, <-1, 99, 10.5> pigment { rgbf <0.9, 1, 1, 1> } finish { ambient 0 diffuse 0 } no_image }
box { <-20, -20, -8>, <200, 2, -1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { absorption 0.3 } } }
media { absorption <0.1, 0.05, 0.02> }
media { method 2 scattering { 1, 0.03 } }
fog { distance 60 rgb <0.1, 0.2, 0.3> }
plane { -z, -10 hollow pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
