// Smoke, an emitting medium with densities, and a light shaft.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at 0 angle 45 }
light_source { <5, 8, -6> rgb 1 spotlight point_at 0 radius 10 falloff 16 }
light_source { <-5, 3, -4> rgb 0.4 }
box { <-4, -2, 1.5>, <4, 3, 1.6> pigment { rgb 0.6 } }
sphere { <-1.2, 0, 0>, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.8 } absorption 0.3 density { spherical turbulence 0.4 } samples 6 } } }
sphere { <1.2, 0, 0>, 1 hollow pigment { rgbt 1 } interior { media { emission <1, 0.5, 0.1> density { bozo scale 0.3 color_map { [0.3 rgb 0] [0.8 rgb 1] } } samples 8 } } }
box { <-3, -1.5, -1.5>, <3, 2.5, 1.2> hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.05 } samples 4 } } }
