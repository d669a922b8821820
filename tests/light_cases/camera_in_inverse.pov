#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4 up y*3 direction z*4 }
light_source { <-3, 5, -8> rgb <.8, .7, .6> }
background { rgb <.1, .2, .3> }
#declare Murky = interior { fade_distance 3 fade_power 1 fade_color rgb <.2, .5, .3> }
// Is the camera inside? POV-Ray asks in the box around a shape or group as it was before it was turned inside out.
sphere { <-1.6, .8, 0>, .6 inverse pigment { rgbt <1, .8, .6, .7> } interior { Murky } }
intersection { sphere { <0, .8, 0>, .6 inverse } pigment { rgbt <1, .8, .6, .7> } interior { Murky } }
union { sphere { <1.6, .8, 0>, .6 } inverse pigment { rgbt <1, .8, .6, .7> } interior { Murky } }
merge { intersection { sphere { <-1.6, -.8, 0>, .6 } sphere { <-1.3, -.8, 0>, .6 } inverse } sphere { <-1.2, -.8, 0>, .3 } pigment { rgbt <1, .8, .6, .7> } interior { Murky } }
difference { plane { y, 9 } sphere { <0, -.8, 0>, .6 } pigment { rgbt <1, .8, .6, .7> } interior { Murky } }
sphere { <1.6, -.8, 0>, .6 inverse clipped_by { box { -9, 9 } } pigment { rgbt <1, .8, .6, .7> } interior { Murky } }
