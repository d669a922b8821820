// Which side of a triangle shows its interior texture depends on its corners, and on its normal before a transform.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Out = texture { pigment { rgb <.9, .3, .2> } finish { ambient 1 diffuse 0 } }
#declare In = texture { pigment { rgb <.2, .4, .9> } finish { ambient 1 diffuse 0 } }
#macro Row(A, B, Y)
  triangle { 0, A, B texture { Out } interior_texture { In } }
  triangle { 0, A, B texture { Out } interior_texture { In } translate <1.1, Y, 0> }
  triangle { 0, A, B texture { Out } interior_texture { In } matrix <-1, 0, 0, 0, 1, 0, 0, 0, 1, 3.2, Y, 0> }
  union { triangle { 0, A, B } texture { Out } interior_texture { In } matrix <0.9, 0, -0.4, 0, 1, 0.1, 0.4, 0, 0.9, -1.5, Y, 0> }
  triangle { 0, A, B texture { Out } interior_texture { In } matrix <-1, 0, 0, 0, 1, 0, 0, 0, -1, -2.2, Y, 0> }
#end
camera { orthographic location <0.6, 0, -9> right 6.5 * x up 4.9 * y }
Row(<1, 0, 0.4>, <0.3, 0.9, 0>, 0.1)
Row(<0.3, -0.9, 0>, <1, -0.2, 0.4>, 0.2)
Row(<0.1, 0.9, 1>, <-0.2, -0.5, 0.5>, -1.2)
Row(<0.7, 0.2, 1.5>, <-0.7, 0.1, 1.1>, -2.1)
Row(<-0.7, 0.2, 1.5>, <0.7, 0.3, 1.1>, 1.5)
