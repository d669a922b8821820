// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
// What fades inside glass counts in full: with it, the right box would be cut.
#version 3.7;
global_settings{assumed_gamma 1.0 adc_bailout .2}
camera{location <1,2,-5> look_at <0,.2,0> angle 50}
light_source{<3,4,-6> rgb <1,.9,.7>}
background{rgb <.1,.2,.4>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>}}
sphere{<-.7,.2,0>,1 pigment{rgbf <1,.9,.8,.9>} interior{ior 1.4 fade_distance .5 fade_power 2} finish{reflection .3}}
box{<.4,-.6,-1>,<1.9,.9,0> pigment{rgbf <1,1,1,.9>} interior{ior 1 fade_distance .5 fade_power 2} finish{ambient 0 diffuse 0}}
