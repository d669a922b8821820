// Bumps so extreme that many are seen from behind: fresnel, metallic and plain mirrors, irid, refraction, total reflection.
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <1, .8, .6> }
camera { location <0, 2, -10> look_at 0 angle 24 }
background { rgb <.1, .2, .3> }
light_source { <-3, 6, -4> * 1000 rgb <1, .9, .8> }
sphere { 0, 100 hollow no_shadow pigment { gradient y color_map { [0 rgb <.4, .1, .1>] [1 rgb <.1, .3, .5>] } scale 40 } finish { ambient 1 diffuse 0 } }
#declare Bumps = normal { bumps 3 scale .3 }
disc { <-1.2, -.6, 0>, y, 1 pigment { rgb <.5, .4, .1> } normal { Bumps } finish { diffuse .2 reflection { 0, 1 fresnel } } interior { ior 1.5 } }
disc { <1.2, -.6, 0>, y, 1 pigment { rgb <.9, .4, .1> } normal { Bumps } finish { diffuse .2, .3 reflection { .2, .8 metallic } } }
disc { <0, -.6, 2.2>, y, 1.2 pigment { rgb .6 } normal { Bumps } finish { diffuse .5, .4 irid { .5 thickness .3 } phong .3 } }
disc { <0, -.6, -2.5>, y, 1.4 pigment { rgbt .9 } normal { Bumps } finish { diffuse 0 reflection .3 } interior { ior 1.5 } }
