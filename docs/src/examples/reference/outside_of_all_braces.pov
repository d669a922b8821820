#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.05 diffuse 0.9 } }
camera { location <0, 3, -9> right x*image_width/image_height look_at <0, 0.8, 0> angle 42 }
light_source { <-40, 80, -60> rgb 1 }
background { srgb <0.95, 0.8, 0.6> }
plane { y, 0 pigment { srgb 0.8 } }
union { sphere { y, 1 } torus { 1.4, 0.2 translate y } pigment { srgb <0.3, 0.4, 0.7> } }
