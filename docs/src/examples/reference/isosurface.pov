isosurface {
  function { x*x + y*y + z*z - 1 + 0.25*sin(9*x)*sin(9*y)*sin(9*z) }
  contained_by { sphere { 0, 1.2 } }
  max_gradient 6
  translate y
  pigment { srgb <0.9, 0.5, 0.2> }
}
