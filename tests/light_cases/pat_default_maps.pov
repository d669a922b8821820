// povray +W16 +H12 -A File_Gamma=1.0 +FP16 (linear values)
#version 3.7; global_settings { assumed_gamma 1  }
camera { location <0, 0, -3> look_at 0 angle 67 }
#default { finish { ambient 1 diffuse 0 } }
box { <-2, -1.5, 0>, <-1, 0, 1> pigment { agate scale 0.4 } }
box { <-1, -1.5, 0>, <0, 0, 1> pigment { bozo scale 0.2 } }
box { <0, -1.5, 0>, <1, 0, 1> pigment { marble scale 0.7 } }
box { <1, -1.5, 0>, <2, 0, 1> pigment { wood scale 0.6 } }
box { <-2, 0, 0>, <-1, 1.5, 1> pigment { radial rotate x*90 } }
box { <-1, 0, 0>, <0, 1.5, 1> pigment { spotted scale 0.3 } }
box { <0, 0, 0>, <1, 1.5, 1> pigment { marble turbulence 1 pigment_map { [0 wood scale 0.3] [1 bozo scale 0.3] } } }
box { <1, 0, 0>, <2, 1.5, 1> pigment { agate turbulence 1 pigment_map { [0 wood scale 0.3] [1 bozo scale 0.3] } } }
