// What lies farther than 1e7 along the ray is not there.
#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,0,0> look_at z angle 60} background{rgb <.4,.5,.9>} #default { finish { ambient .5 diffuse 0 } }
plane{y,-1e6 pigment{checker rgb .9 rgb <.2,.3,.6> scale 3e6}}
intersection { plane { -y,-1 } plane { -x,.1 } scale 1.2e6 pigment { rgb x } }
