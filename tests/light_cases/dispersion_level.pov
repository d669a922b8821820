// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings{assumed_gamma 1 max_trace_level 3 }
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
intersection{box{-1,1} plane{<0,1,-1>,.3} pigment{rgbt .9} finish{ambient 0 diffuse 0 reflection .2} interior{ior 1.6 dispersion 1.2 dispersion_samples 4} rotate 25*y}
