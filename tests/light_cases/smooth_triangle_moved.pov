// The normals of a smooth triangle get length 1 at each `scale`; other steps stretch them. What one step twists is gone for good.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <3, 5, -6> rgb 1 parallel point_at 0 }
#default { pigment { rgb 1 } finish { ambient 0.1 diffuse 1 } }
#declare Sail = smooth_triangle { <-0.5, -0.5, 0>, <-1, -1, -2>, <0.5, -0.5, 0>, <1, -0.2, -1>, <0, 0.5, 0>, <0.2, 1, -1> }
#declare Shear = transform { matrix <1, 0.2, 0, 0, 1, 0.3, 0.4, 0.3, 1.4, 0, 0, 0> }
#macro Show(X, Y, Thing) object { Thing translate <X - 1.53, Y - 1.02, 0> } #end
Show(0, 0, object { Sail scale <1, 1.2, 1> transform Shear })
Show(1, 0, object { Sail transform Shear scale <1, 1.2, 1> })
Show(2, 0, object { Sail transform Shear })
Show(3, 0, object { Sail transform { scale <0.8, 1.2, 3> } rotate 20*x })
Show(0, 1, union { object { Sail scale <1, 1.2, 1> transform Shear } rotate 20*x scale 0.9 })
Show(1, 1, union { object { Sail scale <1, 1.2, 3> } rotate 20*x transform Shear })
#declare Bent = smooth_triangle { <1, 0, 0>, 1, 1, 1, <0, 0, 1>, <1, 0, 0> }
Show(2, 1, object { Bent rotate 10*y })
Show(3, 1, object { Bent scale <2, 1, 1.5> scale <1, 1.3, 0.7> })
#declare Bow = smooth_triangle { <0.543, 0.917, 0.679>, <0, 0.3, -1>, <0.93, 0.663, -0.317>, <0.3, 0, -1>, <0.096, -0.431, -0.791>, <-0.3, 0, -1> }
Show(0, 2, object { Bow rotate 10*y })
Show(1, 2, object { Bow matrix <1, 0.228, 0, 0.224, 1, 0, 0, -0.215, 1, 0, 0, 0> })
Show(2, 2, object { Bow matrix <1, 0.32, 0, 0.275, 1, 0, 0, -0.296, 1, 0, 0, 0> translate x })
