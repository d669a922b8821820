#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
background { rgb <.2,.4,.8> }
light_source { <3,6,-4> rgb 2 spotlight point_at <0,1,0> radius 8 falloff 12 }
media { method 2 samples 3 scattering { 1, .05 extinction 0 } }
sphere { <0,1,0>, .8 pigment { rgb 1 } }
