// Where a picture is one of several pigments, what `filter` and `transmit all` say of it makes no shadow lighter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 3, 0> direction -y right 4*x up 3*z }
light_source { <0, 10, 0> rgb 1 parallel point_at 0 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#default { finish { ambient 0 diffuse 0 } }
#declare Picture = pigment { image_map { function 3, 3 { 0.5 } transmit all 0.6 } }
#declare Film = pigment { gradient y pigment_map { [0 rgb 1 transmit 0.3] } }
#declare Row = 0;
#macro Show(Column, Texture)
  box { <Column - 2, 1, Row - 1.5>, <Column - 1.1, 1.5, Row - 0.6> texture { Texture } no_image }
#end
Show(0, texture { pigment { Picture } })
Show(1, texture { pigment { gradient x pigment_map { [0 Picture] } } })
Show(2, texture { pigment { average pigment_map { [1 Picture] } } })
Show(3, texture { pigment { gradient x pigment_map { [0 Picture] [1 Film] } } })
#declare Row = 1;
Show(0, texture { gradient x texture_map { [0 pigment { gradient x pigment_map { [0 Picture] } }] } })
Show(1, texture { material_map { function 2, 2 { 0 } texture { pigment { gradient x pigment_map { [0 Picture] } } } } })
Show(2, texture { pigment { gradient x pigment_map { [0 image_map { function 3, 3 { pigment { rgb 0.7 } } filter all 0.5 }] } } })
Show(3, texture { pigment { gradient x pigment_map { [0 image_map { function 3, 3 { 0.5 } once }] } translate 9 } })
