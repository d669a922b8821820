// A coarse `accuracy` of a parametric.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
parametric { function { sin(u)*cos(v) } function { sin(u)*sin(v) } function { cos(u) } <0, 0>, <2*pi, pi> contained_by { box { -1.1, 1.1 } } max_gradient 2 accuracy 0.1 pigment { rgb <1, 0.4, 0.2> } }
