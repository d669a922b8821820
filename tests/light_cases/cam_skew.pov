// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <1,2,-5> right <1.2,.2,.1> up <.1,.8,.2> direction <.2,.1,1.3> sky <.3,1,0> look_at <.1,.2,0>}
light_source{<3,4,-6> rgb 1}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>}}
sphere{0,1 pigment{rgb <.8,.3,.2>} finish{} }
