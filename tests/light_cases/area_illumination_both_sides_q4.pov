// povray +W16 +H12 -A +Q4 File_Gamma=1.0 +FP16
// At quality 4 too, what a whole grid shines on answers on both sides.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#default { finish { ambient 0 } }
camera { location <-1.512, 0.131, -5.562> angle 30 }
light_source { <4.85, 3.043, -4.805> rgb 1 area_light <0.73, -0.228, -0.66>, <-0.218, 0.742, -0.489>, 3, 3 area_illumination }
union {
  triangle { <-0.678, 0, 0>, <0, -0.947, 0>, <0, 0, -0.675> }
  smooth_triangle { <0.671, 0, 0>, <0.678, 0, 0>, <0, -0.947, 0>, <-0.088, -0.813, -0.459>, <0, 0, -0.675>, <0, 0, -0.675> }
  pigment { rgb 1 }
  scale 2
}
sphere { <-2.5, 0.8, 0>, 0.7 pigment { rgb 1 } no_shadow }
