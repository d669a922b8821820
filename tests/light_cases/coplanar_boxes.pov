// Of boxes with faces in one plane, POV-Ray shows the one that the order of its bounding boxes brings first.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
box { -1, 1 pigment { rgb <1, 0, 0> } }
box { <-1.5, -1, -1>, 1 pigment { rgb <0, 1, 0> } }
box { -1, <1.2, 1.1, 1> pigment { rgb <0, 0, 1> } }
