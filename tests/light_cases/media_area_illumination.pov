#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 1 spotlight point_at <0,1,0> radius 4 falloff 9 fade_distance 4 fade_power 2 area_light x, z, 3, 3 area_illumination }
box { <-.2,1.8,-.4>, <.2,2.2,0> pigment { rgb <1,.5,.2> } }
sphere { <0,1,0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { scattering { 1, .6 } density { spherical scale 1.5 translate y } } } }
