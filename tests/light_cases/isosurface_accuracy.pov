// Isosurfaces are met behind their surface, by up to their accuracy: what a fine pattern, a mirror and a shadow show.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> direction z right x*4/3 up y angle 45 }
light_source { <3, 6, -5> rgb 1 }
background { rgb 0.1 }
plane { y, -1.2 pigment { checker rgb 0.9, rgb <0.4, 0.2, 0.1> } }
isosurface {
  function { x*x + y*y + z*z - 1 + 0.2*sin(5*x)*sin(5*y)*sin(5*z) } max_gradient 4 accuracy 0.02
  contained_by { sphere { 0, 1.3 } }
  pigment { function { select(mod(abs(20*x + 30*y + 10*z), 1) - 0.5, 0, 1) } }
  finish { ambient 0.1 reflection 0.3 }
  translate -1.1*x
}
difference {
  isosurface {
    function { max(abs(x), abs(y), abs(z)) - 0.8 } max_gradient 1.5 accuracy 0.05 max_trace 3
    contained_by { box { -1, 1 } }
  }
  sphere { <0, 0.8, -0.8>, 0.6 }
  pigment { gradient z color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 1, 1>] } scale 0.1 }
  finish { ambient 0.1 }
  rotate 30*y scale 1.2 translate 1.3*x
}
