// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings{assumed_gamma 1 adc_bailout 0.1 max_trace_level 8}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3}}
sphere{<-1.2,0,0>,.9 pigment{rgbft<.8,.4,.9,.5,.4>} finish{ambient .1 diffuse .2 reflection{<.2,.5,.1>,<.9,.4,.6>} conserve_energy} interior{ior 1.3}}
sphere{<0.4,0,0.5>,.9 pigment{rgbft<.8,.4,.9,.5,.4>} finish{ambient .1 diffuse .2 reflection{<.2,.5,.1>,<.9,.4,.6>} conserve_energy} interior{ior 1}}
sphere{<0.2,0,-1.4>,.9 pigment{rgbft<.8,.4,.9,.5,.4>} finish{ambient .1 diffuse .2 reflection{<.2,.5,.1>,<.9,.4,.6>} conserve_energy} interior{ior 1.1}}