#version 3.7;
global_settings { assumed_gamma 1 }
// A sphere's surface without a second hit: the plane in the difference finds no inside.
camera { location <0, 0, -4> angle 50 }
#declare Ball = parametric {
    function { sin(u)*cos(v) } function { cos(u) } function { sin(u)*sin(v) } <0, 0>, <pi, 2*pi>
    contained_by { box { -1.01, 1.01 } } max_gradient 2 accuracy .0001 precompute 8 x, y, z
    pigment { rgb <1, .7, .3> } finish { ambient 0 diffuse 0 emission 1 }
}
intersection { object { Ball } box { <-.6, -2, -2>, <.4, 2, 2> pigment { rgb <.2, .4, 1> } } translate -.8*x }
difference { box { <-.7, -.7, -.2>, <.7, .7, 1> pigment { rgb <.3, 1, .4> } } object { Ball scale .6 } translate .9*x }
