#version 3.7;
global_settings { assumed_gamma 1 number_of_waves 4 }
#default { normal { dents .3 scale .1 } }
camera { location <.5, 2.3, -6> look_at 0 angle 60 normal { ripples .2 scale .3 translate .1 } }
light_source { <2, 4, -6> 1 }
sphere { 0, 1 pigment { gradient y scale 2 translate y } normal { bumps 0 } }
plane { y, -1 pigment { gradient x scale 40 translate -20*x } normal { bumps 0 } }
background { rgb z }
