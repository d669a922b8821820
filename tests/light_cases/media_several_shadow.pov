#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_source { <3,6,-4> rgb 1 }
sphere { <0,1,0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior {
  media { method 3 samples 5 intervals 3 aa_level 2 scattering { 1, .6 extinction 0 } }
  media { absorption 1 density { bozo scale .4 } }
} }
