// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
camera{location <1,2,-5> look_at <0,.2,0> angle 50}
light_source{<3,4,-6> rgb <1,.9,.7>}
background{rgb <.1,.2,.4>}
plane{y,-1 pigment{checker rgb .9 rgb <.2,.3,.6>}}
sphere{0,1 pigment{rgb <.8,.3,.2>} finish{} }
