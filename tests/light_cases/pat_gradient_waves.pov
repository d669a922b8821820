// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values except no-gamma scenes)
#version 3.7;
global_settings{assumed_gamma 1.0}
camera{location <1,2,-5> look_at <0,.2,0> angle 50}
light_source{<3,4,-6> rgb <1,.9,.7>}
background{rgb <.1,.2,.4>}
union{box{<-2,1.2,0>,<2,1.6,.1> pigment{gradient x color_map{[0 rgb 0][1 rgb 1]} ramp_wave}}box{<-2,0.7,0>,<2,1.1,.1> pigment{gradient x color_map{[0 rgb 0][1 rgb 1]} triangle_wave}}box{<-2,0.2,0>,<2,0.6,.1> pigment{gradient x color_map{[0 rgb 0][1 rgb 1]} sine_wave}}box{<-2,-0.3,0>,<2,0.1,.1> pigment{gradient x color_map{[0 rgb 0][1 rgb 1]} scallop_wave}}box{<-2,-0.8,0>,<2,-0.4,.1> pigment{gradient x color_map{[0 rgb 0][1 rgb 1]} cubic_wave}}box{<-2,-1.3,0>,<2,-0.9,.1> pigment{gradient x color_map{[0 rgb 0][1 rgb 1]} poly_wave 3}} finish{ambient 1 diffuse 0}}
