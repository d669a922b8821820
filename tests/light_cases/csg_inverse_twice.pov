// `inverse` said twice is not said at all.
#version 3.7;
#include "csg.inc"
#declare Outside = sphere { 0, 1 inverse texture { TB } }
#declare Gap = union { sphere { -x, 1 } box { <0, -.5, -.5>, 1.2 } texture { TG } inverse }
intersection { box { <-1.6, .2, -.4>, <-.2, 1.6, .4> texture { TC } } object { Outside inverse translate <-1.2, 1, -.4> } }
intersection { box { <.2, .2, -.4>, <1.6, 1.6, .4> texture { TC } } sphere { <1.2, 1, -.6>, .8 inverse inverse inverse texture { TG } } }
intersection { box { <-1.6, -1.5, -.4>, <0, -.1, .4> texture { TC } } object { Gap inverse translate <-.6, -1, -.4> } }
intersection { box { <.2, -1.5, -.4>, <1.6, -.1, .4> texture { TC } } plane { y, -.8 inverse inverse texture { TB } } }
