// Near the axis of an open lathe is outside.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 4, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
intersection {
  box { -1.2, 1.2 pigment { rgb <1, 0.4, 0.2> } }
  lathe { linear_spline 4, <0.5, -2>, <1, -1>, <1, 1>, <0.5, 2> pigment { rgb <0, 1, 0.4> } }
}
difference {
  box { <1.5, -1, -1>, <3, 1, 1> pigment { rgb <1, 0.4, 0.2> } }
  lathe { bezier_spline 4, <0.5, -2> <0.3, 0> <0.3, 0.5> <0.5, 2> pigment { rgb <0, 0.6, 1> } translate 2*x }
}
difference {
  box { <-3, -1, -1>, <-1.5, 1, 1> pigment { rgb <1, 0.4, 0.2> } }
  lathe { cubic_spline 6, <1, -3> <1, -2> <0.4, -1> <0.4, 0.9> <1, 2> <1, 3> pigment { rgb <0, 0.6, 1> } translate -2*x }
}
