#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*6 up y*4.5 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
plane { z, 5 pigment { checker rgb <.6, .5, .4> rgb <.3, .9, .7> } }
// What an earlier word of the same finish leaves behind: albedo stays, and so do a mirror's metallic, falloff and exponent.
#declare Dull = finish { diffuse albedo .5 brilliance 2 }
#default { pigment { rgb <.9, .5, .3> } }
sphere { <-2, 1, 0>, .9 finish { brilliance 2 diffuse albedo .5 diffuse .4 } }
sphere { <0, 1, 0>, .9 finish { specular albedo .5 specular .4 roughness .1 phong albedo .2 phong .3 } }
sphere { <2, 1, 0>, .9 finish { reflection { .2, .8 metallic falloff 3 exponent 2 } reflection { .1, .9 } } }
sphere { <-2, -1, 0>, .9 finish { reflection { .2, .8 fresnel } reflection { .5 } } }
// A finish on top of another begins with plain numbers.
sphere { <0, -1, 0>, .9 finish { Dull diffuse .5 } }
#default { finish { specular albedo .5 diffuse albedo .7 } }
sphere { <2, -1, 0>, .9 finish { roughness .1 brilliance 3 } }
