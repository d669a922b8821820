text { ttf "timrom.ttf" "durer" 0.2, 0 pigment { color rgb <0.8, 0.3, 0.1> } scale 1.6 translate -1.6*x }
