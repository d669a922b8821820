// povray +W16 +H12 -A File_Gamma=1.0 +FP16
// Parts of a union without an interior fill one inside together: fog shows where a ray has entered two of them.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { angle 45.804 location <1.58, 0.18, -3.359> look_at <0.265, 0.189, -0.111> }
fog { distance 8.39 rgb 0.703 }
union {
  sphere { 0, 1.2 }
  cone { <-0.673, -0.928, -0.297>, 0.866, <0.847, 0.587, 0.599>, 0.073 hollow }
  texture { pigment { rgbt <1, 0.5, 0.3, 0.7> } }
}
union { sphere { <-1, 1, 0>, 0.6 hollow } sphere { <-1, 1, 0.5>, 0.6 hollow } pigment { rgbt <0.2, 0.5, 1, 0.6> } }
