// Walls of open cylinders and cones are inside: taken away once, the other wall shows, and nothing after the second time.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
plane { -z, -4 pigment { checker rgb <1, 0.8, 0.3> rgb <0.2, 0.4, 0.9> } }
#declare Tube = cylinder { -0.8*y, 0.8*y, 0.5 open }
#declare Hat = cone { -0.8*y, 0.6, 0.8*y, 0.2 open }
#declare Red = texture { pigment { rgb <1, 0.4, 0.2> } }
#declare Green = texture { pigment { rgb <0, 1, 0.4> } }
difference { object { Tube texture { Red } } object { Tube texture { Green } } translate -1.4*x }
difference { object { Tube texture { Red } } object { Tube texture { Green } } object { Tube texture { Green } } }
difference { object { Hat texture { Red } } object { Hat texture { Green } } rotate 30*x translate 1.4*x }
