// Films shine in the light of the middle of a grid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> angle 30 }
light_source { <-3, 2, -6> rgb <1, 1, 1> area_light <1, -1, -1>, <0, -1, 1>, 2, 5 area_illumination }
box { -1, 1 texture { pigment { rgb 1 } finish { irid { 0.3 thickness 1 } } } }
