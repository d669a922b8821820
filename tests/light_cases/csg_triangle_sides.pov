// Which side of a flat triangle shows its interior texture depends on how it was moved; that of a polygon on its first corners.
#version 3.7;
#include "csg.inc"
#declare Out = texture { pigment { rgb <.9, .3, .2> } }
#declare In = texture { pigment { rgb <.2, .4, .9> } }
#declare T = triangle { <-1, 0, 0>, <0, 1, .5>, <.3, -.2, -.4> texture { Out } interior_texture { In } }
#declare Moved = union { object { T } object { T rotate 70*y translate .9*y } }
#declare Turned = polygon { 5, <0, 0, 0>, <1, .2, 0>, <.4, .3, 0>, <.6, 1, 0>, 0 texture { Out } interior_texture { In } }
object { T scale <1, -1, 1> translate <2.2, -.3, 0> }
object { T rotate 170*x translate <2.2, -1.3, 0> }
union { object { T translate 1.2*x } object { T rotate 90*x } scale <-1, 1, .6> rotate 20*y translate <-1.2, -1.2, 0> }
object { Moved transform { rotate 200*y scale .7 translate <-1.5, .4, 0> } }
object { Turned translate <.4, .5, 0> }
object { Turned rotate 180*y translate <-.1, 1.3, 0> }
polygon { 6, <0, 0, 0>, <1, 0, 0>, <.5, 0, 0>, <.5, -.9, 0>, <.2, .8, 0>, 0 texture { Out } interior_texture { In } translate <-.4, .6, 0> }
