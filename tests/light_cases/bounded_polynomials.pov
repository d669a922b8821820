// Polynomials by themselves are seen within their bound as it is, whatever box is around it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -40> direction z right x*4/3 up y angle 55 }
light_source { <20, 30, -100> rgb 1 }
background { rgb 0.1 }
#default { finish { ambient 0.2 diffuse 0.7 } }
quartic {
  <1, 0, 0, 0, 2, 0, 0, -2, 0, -104, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, -2, 0, 56, 0, 0, 0, 0, 1, 0, 104, 0, 784>
  pigment { rgb <1, 0.3, 0.2> }
  bounded_by { sphere { 0, 12 } }
  rotate <30, 40, 0> translate -8*x
}
cubic {
  <0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, -9>
  pigment { rgb <0.2, 1, 0.3> }
  bounded_by { sphere { 2*x, 7 } }
  rotate <10, 60, 0> translate <9, 6, 0>
}
poly {
  2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -49>
  pigment { rgb <0.3, 0.2, 1> }
  bounded_by { box { <-9, -3, -9>, <9, 3, 9> } }
  rotate 30*z translate <9, -8, 0>
}
