#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 }
// A ray meets no blob nearer than 0.01 to its start, whatever its scale: glass that is thinner has one surface, in shadows too.
camera { location <1.176, 1.313, -6> look_at <0.094, 0.252, -0.206> angle 32.458 }
light_source { <-5,5,-6> 1 }
blob { threshold .5 sphere { 0, 1.5, 2 } sphere { x,1,1} sphere {<-.7,.8,-.3>,1,1 } scale <1,1,.004> pigment { rgbt <.8,.4,.3,.5> } }
plane { -z,-3 pigment { checker } }
