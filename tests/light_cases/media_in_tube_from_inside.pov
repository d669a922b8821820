#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -2> look_at 0 angle 110 }
light_source { <0.2, 0.3, -1> rgb <2, 0, 0> cylinder radius 1 falloff 2 tightness 0 point_at <0, 0, 1> area_light 0.01 * x, 0.01 * y, 2, 2 area_illumination }
light_source { <-1, 0, -2> rgb <0, 2, 0> cylinder radius 0.5 falloff 1.5 tightness 1 point_at <2, 0.2, -1> }
light_source { <0, 1, -3> rgb <0, 0, 2> cylinder radius 1.2 falloff 1.2 point_at <0, -1, -2> area_light 0.01 * x, 0.01 * y, 2, 2 area_illumination }
sphere { 0, 6 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { method 2 samples 4 intervals 2 scattering { 2, 0.05 extinction 0.2 } } } }
