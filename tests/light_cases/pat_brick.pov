// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <1,2,-5> look_at <0,.2,0> angle 50}
light_source{<3,4,-6> rgb <1,.9,.7>}
background{rgb <.1,.2,.4>}
box{-1,1 pigment{brick rgb .2 rgb <1,.3,.2> brick_size <.6,.3,.4> mortar .06} finish{ambient .5}}
