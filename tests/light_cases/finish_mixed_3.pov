#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -8> look_at 0 angle 24 }
background { rgb <.2, .3, .5> }
light_source { <-4, 5, -6> rgb <1, .9, .7> }
light_source { <5, -1, -3> rgb <.3, .4, .6> }
plane { y, -1.2 pigment { checker rgb .8 rgb <.3, .5, .2> scale .5 } }
sphere { 0, 1.2
  pigment { bozo color_map { [0 rgb <.9,.3,.2>][1 rgbt <.2,.8,.9,.6>] } scale .4 }
  normal { bumps 0.6 scale .2 }
  finish { reflection { .4 falloff -1 exponent 1 metallic fresnel } irid { 0.176218 thickness 0.463914 turbulence 0 } metallic 0 diffuse albedo 0.7, -.2 emission .2 specular -0.5 brilliance -1 ambient .1 }
  interior { ior 1 }
}
