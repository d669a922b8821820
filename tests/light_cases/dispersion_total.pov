#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <1,1.6,-6> look_at <0,.2,0> angle 110}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
box { <0,1,-7>, <2.5,2.5,-5.9> pigment { rgbf .8 } finish { ambient 0 diffuse 0 } rotate 10*x interior { ior 1.4 dispersion 1.1 dispersion_samples 3 } }
sphere { 0, 1 pigment { rgbf .8 } finish { ambient 0 diffuse 0 } interior { ior 1 dispersion 1.1 } }
