julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 100 translate y pigment { color rgb <0.4, 0.7, 0.6> } }
