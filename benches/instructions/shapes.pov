// Shapes whose roots are searched for: tori, quartics, superellipsoids, prisms, text, lathes, blobs, height fields.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0 angle 50 }
light_source { <5, 8, -6> rgb 1 }
plane { y, -1.5 pigment { rgb 0.8 } }
#default { pigment { rgb <0.7, 0.5, 0.3> } finish { phong 0.5 } }
torus { 0.8, 0.25 rotate 50 * x translate <-3, 0, 0> }
superellipsoid { <0.3, 0.6> scale 0.8 rotate 30 * y translate <-1, 0, 0> }
prism { cubic_spline -0.5, 0.5, 7, <-1, 0>, <0, 0.5>, <1, 0>, <0, -1>, <-1, 0>, <0, 0.5>, <1, 0> scale 0.8 rotate -60 * x translate <1, 0, 0> }
text { ttf "timrom.ttf" "durer" 0.3, 0 scale 1.2 translate <1.8, -0.3, 0> }
lathe { bezier_spline 4, <0, -0.8>, <1.2, -0.6>, <0.2, 0.2>, <0.5, 0.8> translate <-2, 0, 2> }
blob { threshold 0.5 sphere { 0, 1, 1 } sphere { <0.7, 0.2, 0>, 0.8, 1 } cylinder { 0, <-0.6, 0.8, 0>, 0.5, 1 } translate <0.5, 0, 2.5> }
quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.5, 0, 0, 0, 0, 1, 0, -2.5, 0, 0.56> scale 0.7 rotate 40 * x translate <3, 0.5, 2> }
sphere_sweep { b_spline 5, <-1, 0, 0>, 0.2, <-0.5, 0.5, 0>, 0.2, <0, -0.5, 0.3>, 0.3, <0.6, 0.4, 0>, 0.2, <1, 0, 0>, 0.1 translate <-3.5, 0, 2.5> }
height_field { function 32, 32 { 0.5 + 0.2 * sin(9 * x) * cos(7 * y) } translate -0.5 scale <2, 0.8, 2> translate <0, -1.2, -2> }
