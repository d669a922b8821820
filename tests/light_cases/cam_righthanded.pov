// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <3,-5,2> sky z right -x*1.33 look_at 0 angle 40}
light_source{<3,-4,6> rgb 1}
plane{z,-1 pigment{checker rgb 1 rgb .3}}
sphere{0,1 pigment{rgb <.8,.3,.2>} finish{} }
