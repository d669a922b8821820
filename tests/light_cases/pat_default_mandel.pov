// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings { assumed_gamma 1  }
camera { location <0, 0, -3> look_at 0 angle 67 }
#default { finish { ambient 1 diffuse 0 } }
box { <-2, -1.5, 0>, <0, 0, 1> pigment { mandel 300 scale 0.5 translate <-0.8, -0.75, 0> } }
box { <0, -1.5, 0>, <2, 0, 1> pigment { mandel 30 exponent 3 scale 0.5 translate <1, -0.75, 0> } }
box { <-2, 0, 0>, <0, 1.5, 1> pigment { mandel 2000 scale 0.5 translate <-0.8, 0.75, 0> } }
box { <0, 0, 0>, <2, 1.5, 1> pigment { julia <0.3, 0.44> 20 scale 0.5 translate <1, 0.75, 0> } }
