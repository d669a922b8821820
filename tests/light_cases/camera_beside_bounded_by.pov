// The camera is inside the intersection, but not within its bounding object.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
light_source { <7, 7, -7> rgb 1 }
fog { distance 10 rgb <0.1, 0.2, 0.3> }
intersection { sphere { 0, 1 inverse } sphere { 0, 30 } bounded_by { sphere { 0, 2 } } pigment { rgb x } finish { ambient 0.3 } }
