// A small sphere hides the centre of the area light, so that the mist above the floor sends no light to rays that gather light,
// although `media on` lets them cross it.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 20 media on } }
camera { location <0, 1, -3> look_at y angle 60 right x up y }
light_source { <0, 5, 0> rgb 1 area_light x*4, z*4, 5, 5 }
sphere { <0, 4.9, 0>, 0.15 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.5 } }
sphere { <0, 2.5, 0>, 0.8 hollow pigment { rgbt 1 } interior { media { intervals 1 samples 4 scattering { 1, rgb 0.3 } } } }
