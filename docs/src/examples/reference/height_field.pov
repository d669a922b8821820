height_field {
  function 60, 60 { 0.35 + 0.3*sin(7*x)*cos(9*y) }
  smooth
  translate <-0.5, 0, -0.5> scale <3, 1.5, 3>
  pigment { srgb <0.3, 0.6, 0.4> }
}
