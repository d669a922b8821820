// Ten thousand objects by a macro.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 30, -60> look_at 0 angle 50 }
light_source { <40, 60, -50> rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
#macro R(I, K) abs(mod(sin(I * 12.9898 + K * 78.233) * 43758.5453, 1)) #end
#macro Ball(I) sphere { <R(I, 0) * 60 - 30, R(I, 1) * 20 - 10, R(I, 2) * 60 - 30>, 0.1 + R(I, 3) * 0.4 pigment { rgb <R(I, 4), R(I, 5), R(I, 6)> } } #end
#for (I, 1, 10000) Ball(I) #end
