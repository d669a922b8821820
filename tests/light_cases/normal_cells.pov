// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
// Cells without a list of normals are bumped where their numbers jump.
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <1,2,-5> look_at <0,.2,0> angle 50}
light_source{<3,4,-6> rgb <1,.9,.7>}
background{rgb <.1,.2,.4>}
plane{y,-1 pigment{rgb .8} normal{hexagon 1 accuracy .3}}
sphere{<-.9,.2,0>,1 pigment{rgb .8} normal{checker 2 accuracy .2 scale .4}}
sphere{<1.2,.2,0>,1 pigment{rgb .8} normal{brick 2 accuracy .2 scale .1}}
