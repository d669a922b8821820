// Lights of a round grid stand a little beside their places: a hole of 0.002 shows where.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, -0.5, 0> direction -y right 0.016*x up 0.012*z translate <-0.707, 0, -0.707> }
plane { y, -1 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
disc { 0, y, 100, 0.002 pigment { rgb 0 } }
light_source { <0, 1, 0> rgb 2 area_light 2*x, 2*z, 3, 3 circular }
