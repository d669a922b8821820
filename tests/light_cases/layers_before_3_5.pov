// At versions up to 3.1 the filter of an upper layer transmits light untinted, to the layer below, to what is behind and in shadows.
#version 3.5;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> right x*4/3 angle 40 }
light_source { <-4, 5, -7> rgb 1 }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
#declare Lower = texture { pigment { rgbft <0.9, 0.4, 0.1, 0.3, 0.2> } finish { ambient 0.2 diffuse 0.7 } }
#declare Upper = texture { pigment { gradient y color_map { [0 rgbf <0.3, 0.8, 0.6, 0.7>] [1 rgbft <0.9, 0.2, 0.6, 0.3, 0.2>] } } finish { ambient 0.1 diffuse 0.4 } }
#declare Of_35 = texture { Lower } texture { Upper }
#version 3.1;
#declare Of_31 = texture { Lower } texture { Upper }
sphere { <-1.2, 0.8, 0>, 0.7 texture { Lower } texture { pigment { rgbf <0.3, 0.8, 0.6, 0.7> } finish { ambient 0.1 diffuse 0.4 } } }
sphere { <1.2, 0.8, 0>, 0.7 texture { Lower } }
sphere { <-0.4, -0.8, 0>, 0.7 texture { Of_35 } }
#version 3.7;
sphere { <1.2, -0.8, 0>, 0.7 texture { Of_31 } }
#version 3.5;
