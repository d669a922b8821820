#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye angle 154 location <-.7, 2.9, -3.9> look_at 0 }
light_source { <5.8, 4.3, -3.6> <.5, 0, 0> parallel point_at 0 fade_distance 7.7 fade_power 1 }
light_source { <5.8, 4.3, -3.6> <0, .5, 0> parallel point_at 0 fade_distance 7.7 fade_power 3 }
light_source { <5.8, 4.3, -3.6> <0, 0, .5> parallel point_at 0 fade_distance 7.7 fade_power 1.5 }
plane { y, -1.5 pigment { rgb 1 } }
