// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
// From the last entry's number on it is the last that counts, also of several at one number.
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <1,2,-5> look_at <0,.2,0> angle 50}
light_source{<3,4,-6> rgb <1,.9,.7>}
plane{y,-1 pigment{mandel 20 color_map{[0 rgb 1][.5 rgb x][1 rgb y][1 rgb z]} rotate 90*x}}
sphere{<-.9,.2,0>,1 pigment{function{max(0, min(1, x+1.5))} pigment_map{[0 rgb x][.5 rgb y][.5 rgb 1][1 rgb y][1 rgb z]}}}
sphere{<1.2,.2,0>,1 pigment{gradient y color_map{[0 rgb x][1 rgb y][.5 rgb z]}}}
