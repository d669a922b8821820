// A camera starts from the one of `#default` before it, not of the one after it.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { camera { location <1, 2, -6> right 1.2 * x look_at 0 angle 40 } }
camera { up 0.8 * y look_at <0.3, 0, 0> }
#default { camera { location <0, 0, -50> look_at 0 angle 10 } }
box { -1, 1 pigment { gradient x } finish { ambient 1 } }
