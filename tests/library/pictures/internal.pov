// Functions of functions.inc as pigments, each on a tile from -2 to 2.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera { location <14, 10, -1002> right 32*x up 24*y direction 1000*z }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare Bands = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.5 rgb <0.9, 0.9, 0.3>] [0.5 rgb <0.6, 0.1, 0.1>] [1 rgb 1] }
#declare Count = 0;
#macro Tile(Shown)
  box {
    -2, 2
    pigment { function { 0.5 + 0.25*Shown(x, y, z + 2.1) } color_map { Bands } }
    translate <4*mod(Count, 8), 20 - 4*int(Count/8), 0>
  }
  #declare Count = Count + 1;
#end
#declare F = function(x, y, z) { f_sphere(x, y, z, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_ellipsoid(x, y, z, 1, 0.6, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_torus(x, z, y, 1.2, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_heart(x, z, y, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_rounded_box(x, y, z, 0.3, 1, 0.7, 0.6) } Tile(F)
#undef F #declare F = function(x, y, z) { f_superellipsoid(x, y, z, 0.4, 0.6) } Tile(F)
#undef F #declare F = function(x, y, z) { f_noise3d(2*x, 2*y, 2*z)*2 } Tile(F)
#undef F #declare F = function(x, y, z) { f_snoise3d(x, y, z) } Tile(F)
#undef F #declare F = function(x, y, z) { f_ridged_mf(x, y, z, 0.5, 2, 4, 0.9, 1.2, 2) } Tile(F)
#undef F #declare F = function(x, y, z) { f_hetero_mf(x, y, z, 0.5, 2, 4, 0.3, 1, 2) } Tile(F)
#undef F #declare F = function(x, y, z) { f_ridge(x, y, z, 0.5, 3, 0.5, 0.3, 1, 2) } Tile(F)
#undef F #declare F = function(x, y, z) { f_helix1(x, y, z, 2, 2, 0.2, 0.8, 1, 1, 0) } Tile(F)
#undef F #declare F = function(x, y, z) { f_spiral(x, y, z, 0.5, 0.3, 2, 0, 0, 0) } Tile(F)
#undef F #declare F = function(x, y, z) { f_r(x, y, z) } Tile(F)
#undef F #declare F = function(x, y, z) { f_th(x, y, z) } Tile(F)
#undef F #declare F = function(x, y, z) { f_ph(x, y, z) } Tile(F)
#undef F #declare F = function(x, y, z) { f_hex_x(x, y, z, 0.3) } Tile(F)
#undef F #declare F = function(x, y, z) { f_hex_y(x, y, z, 0.3) } Tile(F)
#undef F #declare F = function(x, y, z) { f_mesh1(x, y, z, 0.5, 0.5, 1, 0.3, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_folium_surface(x, y, z, 0.05, 1, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_klein_bottle(x, y, z, 0.1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_steiners_roman(x, y, z, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_devils_curve_2d(x, y, z, 0.3, 0.6, 1, 1, 0, 0) } Tile(F)
#undef F #declare F = function(x, y, z) { f_crossed_trough(x, y, z, 0.5) } Tile(F)
#undef F #declare F = function(x, y, z) { f_blob(x, y, z, 1, 1, 1, 1, 0.3) } Tile(F)
#undef F #declare F = function(x, y, z) { f_kummer_surface_v1(x, y, z, 0.1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_polytubes(x, y, z, 5, 0.8, 0.2, 1, 0.5, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_spikes(x, y, z, 1, 1, 1, 0.5, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_sine_wave(x + 0.3*y, 1, 0.8) } Tile(F)
#undef F #declare F = function(x, y, z) { f_scallop_wave(f_r(x, y, 0), 1.5, 0.5) } Tile(F)
#undef F #declare F = function(x, y, z) { f_odd(x, y, z, 0.1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_umbrella(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_quantum(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_paraboloid(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_pillow(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_piriform(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_mitre(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_boy_surface(x, y, z, 0.01, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_cushion(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_bicorn(x, y, z, 0.4, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_flange_cover(x, y, z, 0.01, 2, 1, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_dupin_cyclid(x, y, z, 0.01, 1, 0.5, 0.6, 0.5, 2) } Tile(F)
#undef F #declare F = function(x, y, z) { f_comma(x, y, z, 0.5) } Tile(F)
#undef F #declare F = function(x, y, z) { f_strophoid(x, y, z, 0.4, 1, 1, 1) } Tile(F)
#undef F #declare F = function(x, y, z) { f_glob(x, y, z, 0.4) } Tile(F)
#undef F #declare F = function(x, y, z) { f_hunt_surface(x, y, z, 0.01) } Tile(F)
#undef F #declare F = function(x, y, z) { f_torus_gumdrop(x, y, z, 0.2) } Tile(F)
#undef F #declare F = function(x, y, z) { f_witch_of_agnesi(x, y, z, 0.4, 0.6) } Tile(F)
