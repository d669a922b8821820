// POV-Ray asks the object that last kept a light away first, and what lets light through counts twice then. A column of the picture is 1 wide,
// each row is a case of its own; the light stands above. What is opaque at its left end is remembered to the right of it.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { orthographic location <8, 10, 6> direction -y right 16*x up 12*z }
light_source { <8, 1000, 6> rgb <0.5, 1, 0.7> parallel point_at <8, 0, 6> }
light_source { <408, 1000, 6> rgb <0.5, 0, 0.2> parallel point_at <8, 0, 6> }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }

// A box in row Z that is opaque for one column, and lets half of the light through behind it.
#macro Stripes(Left, Columns) pigment { gradient x color_map { [1/Columns rgb 1] [1/Columns rgb <1, 0.9, 0.8> transmit 0.5] } scale Columns translate Left*x } #end
#macro Slab(Left, Right, Bottom, Top, Z) <Left, Bottom, Z + 0.1>, <Right, Top, Z + 0.9> #end
#macro Stripe(Left, Right, Z) box { Slab(Left, Right, 1, 2, Z) Stripes(Left, Right - Left) } #end
#macro Opaque(Left, Right, Bottom, Z) box { Slab(Left, Right, Bottom, Bottom + 0.2, Z) pigment { rgb 1 } no_image } #end
#macro Clear(Left, Right, Bottom, Top, Z) box { Slab(Left, Right, Bottom, Top, Z) pigment { rgb <1, 0.8, 1> transmit 0.8 } #end

// Not of a box alone, of a group without a texture, or with one that lets light through, or of a union.
object { Stripe(1, 4, 0) no_image }
difference { Stripe(5, 8, 0) Opaque(20, 21, 0, 0) no_image }
difference { Stripe(9, 12, 0) Opaque(20, 21, 0, 0) pigment { rgb 1 transmit 0.1 } no_image }
union { Stripe(13, 16, 0) Opaque(20, 21, 0, 0) pigment { rgb 1 } no_image }
// Of a difference, a merge, a clipped union, and within a union.
difference { Stripe(1, 4, 1) Opaque(20, 21, 0, 1) pigment { rgb 1 } no_image }
merge { Stripe(5, 8, 1) Opaque(20, 21, 0, 1) pigment { rgb 1 } no_image }
union { Stripe(9, 12, 1) Opaque(20, 21, 0, 1) pigment { rgb 1 } no_image clipped_by { plane { y, 100 } } }
union { intersection { Stripe(13, 16, 1) box { 0, 20 } } pigment { rgb 1 } no_image }
// Another takes its place, but not above it, nor if light passes it elsewhere.
difference { Stripe(1, 16, 2) Opaque(20, 21, 0, 2) pigment { rgb 1 } no_image }
Opaque(4, 5, 3, 2)
object { Stripe(7, 9, 2) scale <1, 0.2, 1> no_image }
Opaque(11, 12, 0.3, 2)
// What is not the first in the way is not remembered.
difference { Stripe(1, 8, 3) Opaque(20, 21, 0, 3) pigment { rgb 1 } no_image }
Clear(0, 4, 0.2, 0.5, 3) no_image }
difference { Stripe(9, 16, 3) Opaque(20, 21, 0, 3) pigment { rgb 1 } no_image }
Clear(8, 13, 3, 4, 3) no_image }
// Only its nearest surface counts: the one that was cut, and another.
difference { Stripe(1, 8, 4) Clear(4, 9, 0.9, 1.2, 4) scale <1, 1, 1.5> translate -2*z } pigment { rgb 1 } no_image }
difference { Stripe(9, 16, 4) Clear(12, 17, 1.6, 2.2, 4) scale <1, 1, 1.5> translate -2*z } pigment { rgb 1 } no_image }
// What fades and focuses.
difference { Stripe(1, 5, 5) Opaque(20, 21, 0, 5) pigment { rgb 1 } no_image interior { fade_distance 0.5 fade_power 1 fade_color 0 } }
difference { box { Slab(6, 10, 1, 5, 5) Stripes(6, 4) } Opaque(20, 21, 0, 5) pigment { rgb 1 } no_image interior { ior 1.3 fade_distance 2 fade_power 2 fade_color rgb <0.1, 0.4, 0.2> } }
difference { Stripe(11, 15, 5) Opaque(20, 21, 0, 5) pigment { rgb 1 } no_image interior { ior 1.3 caustics 0.4 } }
// From within, where more is in the way.
difference { box { Slab(1, 12, -5, 20, 6) Stripes(1, 11) } Opaque(20, 21, 0, 6) pigment { rgb 1 } interior { fade_distance 20 fade_power 1 fade_color 0 } }
Clear(4, 6, 0.5, 2, 6) no_image }
Clear(8, 10, 0.5, 2, 6) no_image interior { fade_distance 1 fade_power 1 fade_color 0 } }
// Rays through glass have an object of their own, and rays from the eye ask for that, if they have none.
#macro Glass(Left, Right, Z) box { Slab(Left, Right, 6, 7, Z) no_shadow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } } #end
difference { Stripe(1, 8, 7) Opaque(20, 21, 0, 7) pigment { rgb 1 } no_image }
Glass(3, 5, 7)
difference { Stripe(9, 16, 7) Opaque(20, 21, 0, 7) pigment { rgb 1 } no_image }
Glass(9, 10, 7)
Glass(12, 14, 7)
// Less than 0.001 away, as far as 0.0001.
#macro Near(Left, Z, Away) intersection { plane { -y, -Away pigment { rgb 1 transmit 0.8 } } box { Slab(Left, Left + 5, -1, 2, Z) Stripes(Left, 5) } pigment { rgb 1 } no_image } #end
Near(0, 8, 0.0012)
Near(5, 8, 0.0008)
Near(10, 8, 0.00011)
Near(0, 9, 0.00009)
difference { Stripe(6, 10, 9) Opaque(20, 21, 0, 9) pigment { rgb 1 } no_image no_shadow }
difference { Stripe(11, 15, 9) Opaque(20, 21, 0, 9) pigment { rgb 1 } no_image no_reflection }
// Not if the nearest surface has no_shadow, though light from the object next to it is kept away, and what has it may be remembered.
merge { Opaque(1, 2, 1, 10) Clear(2, 5, 1, 2, 10) no_shadow } Clear(3, 7, 2, 3, 10) } pigment { rgb 1 } no_image }
merge { object { Opaque(8, 9, 1, 10) no_shadow } Clear(9, 12, 1, 2, 10) } pigment { rgb 1 } no_image }
union { difference { Stripe(1, 6, 11) Opaque(20, 21, 0, 11) } no_shadow pigment { rgb 1 } no_image }
merge { difference { Stripe(7, 12, 11) Opaque(20, 21, 0, 11) no_shadow } Clear(12, 15, 1, 2, 11) } pigment { rgb 1 } no_image }
