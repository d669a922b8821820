// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings{assumed_gamma 1 adc_bailout 0 max_trace_level 12}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3}}
sphere{0,1.4 pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} } interior{ior 1.5}}sphere{<.2,.1,-.1>,.8 pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} } interior{ior 1.2}}sphere{<-.2,0,-.2>,.4 pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} } interior{ior 2}}