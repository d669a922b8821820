// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <1,2,-5> look_at <0,.2,0> angle 50}
light_source{<3,4,-6> rgb <1,.9,.7>}
background{rgb <.1,.2,.4>}
sphere{0,1.5 pigment{gradient <1,2,-.5> color_map{[0 rgb 0][.3 rgb <1,.5,0>][.3 rgb <0,0,1>][.8 rgb 1]} frequency 2.5 phase .2 sine_wave} finish{ambient 1 diffuse 0}}
