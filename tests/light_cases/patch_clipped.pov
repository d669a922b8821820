// `clipped_by` has no effect on a bicubic patch.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 2
  <-1.5, -1, 0> <-0.5, -1, 0> <0.5, -1, 0> <1.5, -1, 0> <-1.5, -0.3, 0> <-0.5, -0.3, 1> <0.5, -0.3, 1> <1.5, -0.3, 0>
  <-1.5, 0.3, 0> <-0.5, 0.3, 1> <0.5, 0.3, 1> <1.5, 0.3, 0> <-1.5, 1, 0> <-0.5, 1, 0> <0.5, 1, 0> <1.5, 1, 0>
  clipped_by { sphere { 0, 1 } }
  pigment { checker rgb <1, 0.5, 0.2>, rgb <0.2, 0.4, 0.9> scale 0.4 } finish { ambient 1 diffuse 0 } }
