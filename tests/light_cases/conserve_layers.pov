#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*4 up y*3 }
background { rgb <.1, .2, .3> }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
plane { z, 5 pigment { checker rgb <.6, .5, .4> rgb <.3, .9, .7> } }
// What conserve_energy takes from the light that passes, it takes from lower layers too.
sphere { 0, 1.2
  texture { pigment { rgbt <.2, .4, .8, .3> } finish { reflection { .1, .5 falloff 2 } conserve_energy } }
  texture { pigment { rgbft <.2, .9, .8, .3, .4> } finish { reflection { .3, 1.2 fresnel } conserve_energy } normal { bumps .3 scale .2 } }
  interior { ior 1.2 }
}
