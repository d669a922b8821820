#version 3.7; global_settings { assumed_gamma 1 max_trace_level 4 }
// Polynomial surfaces are met from 0.0001 away in the units of their own space: glass that is thinner there has one surface, also where
// it is 0.06 thick in the world, and others have two.
camera { location <100,200,-5000> look_at 0 angle 50 }
#declare Glass = texture { pigment { rgbt <.8,.4,.3,.5> } finish { ambient .6 diffuse 0 } }
polynomial { 2, xyz(2,0,0): 1, xyz(0,2,0): 1, xyz(0,0,2): 1e9, xyz(0,0,0): -1 texture { Glass } scale 1000 translate -1100*x }
quadric { <1,1,1e9>, 0, 0, -1 texture { Glass } scale 1000 translate 1100*x }
plane { -z, -9000 pigment { checker scale 500 } finish { ambient 1 } }
