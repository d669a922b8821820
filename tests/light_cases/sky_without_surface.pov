#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, -3> look_at <0, 1, 0> }
light_source { <10, 10, -20> 1 }
#declare Map = color_map { [0 rgb <.9, .1, .2>] [.5 rgb <.2, .8, .1>] [1 rgb <.1, .3, .7>] }
sky_sphere {
    pigment { slope { <1, .3, .2>, .2, .8 altitude y, 0, .2 } color_map { Map } phase .1 }
    pigment { aoi color_map { [0 rgbt <.8, .6, .4, .5>] [1 rgbt <0, 1, 0, .2>] } turbulence .3 }
}
sphere { 0, 1 pigment { slope y color_map { Map } } finish { reflection .5 ambient .2 } }
plane { y, -1 pigment { image_map { function 8, 8 { pigment { aoi color_map { Map } } } } rotate 90*x } }
