// Before 3.7 a surface keeps back the colour that its filter absorbs.
#version 3.6; global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 40 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
sphere { -0.8*x, 0.9 pigment { rgbf <0.9, 0.4, 0.1, 0.6> } finish { ambient 0.2 diffuse 0.7 } }
sphere { 1.1*x, 0.8 pigment { rgbft <0.2, 0.7, 0.9, 0.5, 0.2> } finish { ambient 0.1 diffuse 0.6 phong 0.5 } }
