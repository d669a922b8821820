#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 70 }
light_source { <-1, 0.5, 0> rgb <3, 0, 0> cylinder radius 0.5 falloff 1 tightness 0 point_at <3, 0, 1> area_light 0.01 * x, 0.01 * y, 2, 2 area_illumination }
light_source { <1, 1, 0> rgb <0, 3, 0> cylinder radius 0.5 falloff 1 tightness 1 point_at <-3, 0, 1.5> }
light_source { <0, -1, 1> rgb <0, 0, 3> cylinder radius 1.5 falloff 1.5 point_at <0.5, 3, -2> area_light 0.01 * x, 0.01 * y, 2, 2 area_illumination }
box { <-9, -9, -5>, <9, 9, 4> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { method 3 samples 6 intervals 3 scattering { 1, 0.05 extinction 0.2 } } } }
