#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,2,-6> look_at <0,.8,0> }
plane { y, 0 pigment { checker rgb 1 rgb .4 } finish { ambient .1 } }
light_group {
  light_source { <3,6,-4> rgb <1,.5,0> }
  sphere { <-1.5,1,1>, .7 pigment { rgb .6 } }
  sphere { <0,1,0>, .5 pigment { rgb .6 } }
  global_lights off
}
light_source { <-3,6,-4> rgb <0,0,1> }
media { scattering { 1, .05 } }
sphere { <0,1,0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { scattering { 1, .4 } } } }
sphere { 0, 30 pigment { rgb .3 } hollow }
