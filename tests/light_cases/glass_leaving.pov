// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings{assumed_gamma 1 adc_bailout 0 max_trace_level 12}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3}}
box{<-2,-.9,0>,<2,2,5> rotate 20*y pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} } interior{ior 1.5}}box{<-2.1,-.8,.5>,<2.1,2.1,2> rotate 5*y pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} } interior{ior 1.2}}box{<-1.9,-.7,1>,<1.9,2.2,3> rotate -8*y pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} } interior{ior 1.8}}