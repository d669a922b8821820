#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb 1 }
#default { finish { ambient 1 diffuse 0 } }
// Which of several surfaces in one place is seen: of objects and of a union's parts the first, of an intersection's the last; planes
// before both. (With few objects: POV-Ray's hierarchy over many decides otherwise.)
union { sphere { 0, .9 pigment { rgb x } } sphere { 0, .9 pigment { rgb y } } sphere { 0, .9 pigment { rgb z } } translate <-2, 1, 0> }
intersection { box { -.7, .7 pigment { rgb x } } box { -.7, .7 pigment { rgb y } } box { -.7, .7 pigment { rgb z } } translate <0, 1, 0> }
difference { box { -.7, .7 pigment { rgb x } } box { <0, 0, -.7>, 1 pigment { rgb y } } translate <2, 1, 0> }
union { intersection { sphere { 0, .9 pigment { rgb x } } plane { y, 0 pigment { rgb y } } } sphere { 0, .9 pigment { rgb z } } translate <-2, -1, 0> }
union { box { -.7, .7 pigment { rgb x } } plane { -z, .7 pigment { rgb y } } clipped_by { box { -.9, .9 } } translate <0, -1, 0> }
intersection { plane { -z, .7 pigment { rgb x } } plane { -z, .7 pigment { rgb y } } box { -.7, .7 pigment { rgb z } } translate <2, -1, 0> }
