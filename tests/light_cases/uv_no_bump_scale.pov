// Bumps in a texture with uv_mapping begin with a normal of length 1, however the object is scaled.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 1, -3> look_at 0.5 }
light_source { <1, 1, -2> rgb 1 }
sphere { 0, 1 texture { uv_mapping pigment { rgb 1 } normal { gradient x 1 no_bump_scale } } scale 2 }
