// Through glass, and through their own front, unions hide the parts that have no image; from the camera itself they do not.
#version 3.7; global_settings{assumed_gamma 1 max_trace_level 8}
camera{location <0,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>} finish{emission .3 ambient 0}}
box { <-3,-1,-3>, <-.6,3,-2.9> pigment { rgbf .9 } no_shadow }
difference { union { box { -.8, .8 no_image } sphere { .8, .4 } } sphere { <-.8,.8,-.8>, .5 } pigment { rgb <1,.5,.5> } translate -x*1.3 }
difference { union { box { -.6, .6 no_image } } pigment { rgbf .9 } interior { ior 1.3 } translate x*1.2 }
