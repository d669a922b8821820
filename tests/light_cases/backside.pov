// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <1,2,-5> look_at 0}
light_source{<3,4,6> rgb 1}
disc{0,<.2,.1,1>,1.5 pigment{rgb 1} finish{diffuse .6,.4}}
