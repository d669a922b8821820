#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.5,0> } plane { y,0 pigment { checker rgb 1 rgb .4 } } sphere { <0,1,0>,1 pigment { rgb <.8,.6,.3> } }
light_source { <3,6,-4> rgb <1,.3,.2> parallel point_at <1,-3,2> area_light <1,1,-.5>,<.3,-.5,1>,2,5 circular }
light_source { <-3,5,-4> rgb <.1,.5,.3> cylinder radius 1 falloff 3 point_at <0,.5,0> area_light <1,1,-.5>,<.3,-.5,1>,3,3 area_illumination }
light_source { <1,4,-7> rgb <.1,.1,.5> parallel spotlight radius 20 falloff 30 point_at 0 area_light 2*x,2*y,3,3 circular orient }
