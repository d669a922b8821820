#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
#declare D = interior { ior 1.2 } #declare E = interior { ior 1.5 dispersion 1.2 } #declare MI = material { interior { D } } #default { pigment { rgbt .8 } }
sphere { <-1.6,0,0>, .7 interior { E } interior { ior 1.2 } }
sphere { 0, .7 interior { dispersion 1.2 } }
sphere { <1.5,0,0>, .7 interior { E } material { MI } }
sphere { <-.8,1.4,0>, .6 material { MI interior { dispersion 1.3 } } }
#declare S = sphere { <.8,1.4,0>, .6 interior { E } } object { S interior { ior 1.2 fade_distance .5 fade_power 1 } }
