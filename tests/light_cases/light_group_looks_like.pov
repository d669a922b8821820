// povray +W16 +H12 -A File_Gamma=1.0 +FP16
// What a group's light looks like is not a part of the group.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#default { finish { ambient 0 } }
camera { location <-1.576, 2.866, -4.546> look_at <1.717, 2.091, -3.135> angle 40 }
light_source { <-7.482, 2.279, -7.703> rgb 1 }
light_group {
  light_source { <-2, 5, -8> <0, 1, 0> looks_like { sphere { <4.2, -2, 4.8>, 0.5 pigment { rgb 1 } } } }
  light_source { <1.717, 2.091, -3.135> rgb <1, 0, 0> looks_like { sphere { 0, 0.4 pigment { rgb 1 } } } }
  sphere { <1.717, 2.091, -2>, 1 pigment { rgb 1 } }
}
