// The walls of a bezier prism face the other way than those of other splines: so interior_texture is on the other side.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-1, 2, -6> look_at <0.5, 0.3, 0> angle 30 }
light_source { <1, 3, -4> rgb 1 }
#declare Outside = texture { pigment { rgb <1, 0, 0> } finish { ambient 0.5 } }
#declare Inside = texture { pigment { rgb <0, 0, 1> } finish { ambient 0.5 } }
prism { bezier_spline 0, 1, 8, <-1, 0>, <1, 1>, <-1, 1>, <1, 0>, <1, 0>, <1, -1>, <-1, -1>, <-1, 0> open texture { Outside } interior_texture { Inside } }
prism { bezier_spline conic_sweep 0.3, 1, 8, <-1, 0>, <-1, -1>, <1, -1>, <1, 0>, <1, 0>, <-1, 1>, <1, 1>, <-1, 0> texture { Outside } interior_texture { Inside } translate x*1.5 }
