// Which side of a polygon shows its interior texture depends on its first corners.
#version 3.7;
#include "csg.inc"
#declare Out = texture { pigment { rgb <.9, .3, .2> } }
#declare In = texture { pigment { rgb <.2, .4, .9> } }
#declare Turned = polygon { 5, <0, 0, 0>, <1, .2, 0>, <.4, .3, 0>, <.6, 1, 0>, 0 texture { Out } interior_texture { In } }
object { Turned translate <.4, .5, 0> }
object { Turned rotate 180*y translate <-.1, 1.3, 0> }
polygon { 6, <0, 0, 0>, <1, 0, 0>, <.5, 0, 0>, <.5, -.9, 0>, <.2, .8, 0>, 0 texture { Out } interior_texture { In } translate <-.4, .6, 0> }
