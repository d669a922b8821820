// Hypercomplex fractals of other functions than sqr and cube.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
julia_fractal { <0.083, -0.1, -0.83, -0.025> hypercomplex exp max_iteration 6 precision 40 slice <0, 0, 0, 1>, 0 pigment { rgb <1, 0.5, 0.2> } translate -1.5*x }
julia_fractal { <0.083, -0.1, -0.83, -0.025> hypercomplex sin max_iteration 6 precision 40 slice <0, 0, 0, 1>, 0 pigment { rgb <1, 0.5, 0.2> } translate 1.5*x }
