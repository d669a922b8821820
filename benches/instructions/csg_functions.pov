// An isosurface of declared functions: their union, intersection and difference by min and max.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at 0 angle 48 }
light_source { <5, 8, -6> rgb 1 }
#declare Ball = function(x, y, z, r) { sqrt(x*x + y*y + z*z) - r }
#declare Brick = function(x, y, z, a, b, c) { max(abs(x) - a, abs(y) - b, abs(z) - c) }
#declare Tube = function(x, y, z, r) { sqrt(x*x + z*z) - r }
#declare Body = function { max(Brick(x, y, z, 1.2, 0.9, 0.8), Ball(x, y, z, 1.45)) }
#declare Holes = function { min(Tube(x, y, z, 0.3), Tube(y, x - 0.2, z, 0.35), Tube(x + 0.7, z, y, 0.25), Tube(x - 0.7, z, y, 0.25)) }
#declare Studs = function { min(Ball(x - 1, y - 1, z, 0.3), Ball(x + 1, y - 1, z, 0.3), Ball(x - 0.5, y - 0.3, z + 0.8, 0.2)) }
isosurface {
  function { min(max(Body(x, y, z), -Holes(x, y, z)), Studs(x, y, z)) }
  contained_by { box { -1.4, 1.4 } } max_gradient 2 pigment { rgb <0.6, 0.7, 0.4> } rotate <20, 30, 0>
}
