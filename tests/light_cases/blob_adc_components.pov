#version 3.7; global_settings { assumed_gamma 1 adc_bailout .1 }
// What is less than adc_bailout of a blob's texture is not seen: of each component by itself, also where others look the same.
camera { location -5*z look_at 0 angle 40 }
#default { finish { ambient 1 diffuse 0 } }
blob { threshold .3 sphere { -.5*x, 1, 1 pigment { rgb y } } sphere { .4*x+.1*y, 1, 1 } sphere { .4*x-.1*y, 1, 1 } pigment { rgb x } translate .7*y }
blob { threshold .3 sphere { -.5*x, 1, 1 pigment { rgb y } } #for (I, 0, 5) sphere { (.2+I/20)*x, 1, .3 } #end pigment { rgb x } translate -.7*y }
