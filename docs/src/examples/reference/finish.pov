#macro Ball(X) sphere { <X, 0.8, 0>, 0.8 pigment { srgb <0.7, 0.2, 0.2> } #end
Ball(-2) finish { diffuse 0.8 } }
Ball(0) finish { phong 0.9 phong_size 20 } }
Ball(2) finish { specular 0.6 roughness 0.005 reflection { 0.3 } } }
