parametric {
  function { u*cos(v) } function { 0.15*v } function { u*sin(v) }
  <-1, 0>, <1, 4*pi>
  contained_by { box { -2, 2 } }
  pigment { srgb <0.5, 0.4, 0.7> }
}
