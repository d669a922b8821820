// Shadows of a transparent isosurface in CSG.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
merge { isosurface { function { abs(sin(x*6))-0.4 } contained_by { box { -1.2, 1.2 } } max_gradient 8 accuracy 0.0005 open } sphere { 0, 0.4 } pigment { rgbt <1, 0.5, 0.2, 0.7> } rotate 30*y }
difference { isosurface { function { abs(sin(x*6))-0.4 } contained_by { box { -1, 1 } } max_trace 2 max_gradient 8 accuracy 0.0005 open } sphere { -z, 0.6 } pigment { rgbt <0.5, 1, 0.2, 0.7> } scale 0.6 translate <-1.5, 0.7, -1> }
intersection { isosurface { function { abs(sin(x*6))-0.4 } contained_by { box { -1.2, 1.2 } } max_gradient 8 accuracy 0.0005 } box { <-1, -3, -3>, <0.9, 3, 3> } pigment { rgbt <0.4, 0.5, 1, 0.7> } rotate 30*y scale 0.5 translate <1.7, 0.9, 0> }
