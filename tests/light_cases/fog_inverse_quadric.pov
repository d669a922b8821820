// A camera in a union that is turned inside out is in it, and sees no fog, if POV-Ray's box of it has no end, as that of a quadric with mixed
// terms, which here is a ball that is flat.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 60 }
background { rgb <0, 0, 1> }
light_source { <4, 3, -4> rgb <1, 0.5, 1> }
#declare Flat = union { quadric { <1, 1, 1>, <1, 1, 1>, <0, 0, 0>, -0.5 pigment { rgb 1 } } }
union { object { Flat inverse } }
plane { -z, -3 pigment { checker rgb 1, rgb 0.2 } }
fog { distance 8 rgb <1, 0, 0> }
