#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
background { rgb <.2,.3,.4> }
light_source { <3,6,-4> rgb 1 }
plane { y, 3 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { absorption .05 emission <.03,.02,0> } } }
sphere { <0,1,0>, 1 pigment { rgb <1,.5,.2> } }
