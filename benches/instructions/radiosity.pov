// A room lit by one window.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 40 error_bound 0.8 recursion_limit 2 pretrace_start 0.08 pretrace_end 0.04 } }
#default { finish { ambient 0 diffuse 0.8 } }
camera { location <0, 1.5, -3.8> look_at <0, 1.3, 0> angle 70 }
light_source { <12, 10, -4> rgb 2 }
difference { box { <-3.1, -0.1, -4.1>, <3.1, 3.1, 4.1> } box { <-3, 0, -4>, <3, 3, 4> } box { <2.8, 0.8, -1>, <3.2, 2.2, 1> } pigment { rgb 0.8 } }
sphere { <-1, 0.6, 1>, 0.6 pigment { rgb <0.8, 0.2, 0.1> } }
box { <0.4, 0, 0.5>, <1.4, 1.2, 1.5> pigment { rgb <0.2, 0.5, 0.8> } }
sphere { 0, 100 hollow inverse pigment { rgb <0.6, 0.8, 1> } finish { emission 1 diffuse 0 } no_shadow }
