// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings{assumed_gamma 1 adc_bailout 0.02 max_trace_level 12}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3}}
box{-1,1 rotate 30*y pigment{rgbf<1,.05,.02,1>} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} reflection <.3,.1,.6>} interior{ior 1.4}}sphere{<1.6,0,-1>,.7 pigment{rgbf<.1,.9,.02,1>} finish{ambient 0 diffuse 0 reflection{0,1 fresnel} reflection <.02,.1,.05>}}sphere{<-1.7,0,1>,1 pigment{rgb 0} finish{reflection <.03,.02,.3>}}
