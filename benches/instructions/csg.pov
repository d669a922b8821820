// CSG with patterned parts, clipping and many operands.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> look_at 0 angle 45 }
light_source { <5, 8, -6> rgb 1 }
difference {
  box { -2, 2 pigment { checker rgb 1 rgb 0.3 scale 0.5 } }
  #for (X, -1, 1) #for (Y, -1, 1)
    cylinder { <X, Y, -3>, <X, Y, 3>, 0.4 pigment { granite scale 0.3 } }
    cylinder { <X, -3, Y>, <X, 3, Y>, 0.3 pigment { rgb <1, 0.5, 0> } }
  #end #end
  sphere { <2, 2, -2>, 1.4 pigment { bozo scale 0.2 } }
  rotate 30 * y
}
merge { sphere { <-3.2, 0, 0>, 0.9 } torus { 0.8, 0.3 translate -3.2 * x } pigment { rgbt <0.3, 0.8, 0.5, 0.5> } }
intersection { sphere { 0, 1.2 } box { -1, 1 } cylinder { -2 * y, 2 * y, 1.1 } pigment { rgb <0.4, 0.5, 0.9> } clipped_by { plane { y, 0.5 } } translate 3.3 * x }
