#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -8> look_at 0 angle 24 }
background { rgb <.2, .3, .5> }
light_source { <-4, 5, -6> rgb <1, .9, .7> }
light_source { <5, -1, -3> rgb <.3, .4, .6> }
plane { y, -1.2 pigment { checker rgb .8 rgb <.3, .5, .2> scale .5 } }
sphere { 0, 1.2
  pigment { bozo color_map { [0 rgb <.9,.3,.2>][1 rgb <.2,.8,.9>] } scale .4 }
  normal { bumps 0.2 scale .2 }
  finish { diffuse albedo -0.3, .4 ambient .1 phong 1 phong_size 0 reflection { rgb <0.75,0.14,0.99> falloff 3  metallic .5 fresnel } }
  interior { ior 1.5 }
}
