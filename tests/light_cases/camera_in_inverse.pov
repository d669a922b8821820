// A camera starts in what is turned inside out where that is in the box that POV-Ray tells of it: fog is nowhere in what is not hollow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-2, 0, -6> }
light_source { 0 rgb 1 }
fog { distance 29 rgb <1, 0, 0> }
#declare Thing = blob { threshold 0.3 cylinder { 1, 0, 1, 1 scale <2, 1, 2> } pigment { rgb 1 } finish { ambient 0.3 } }
object { Thing scale <1, 1, 1.7> inverse }
