// x² + y² - z² = 0.2, by all ten numbers of order 2
poly {
  2, <1, 0, 0, 0, 1, 0, 0, -1, 0, -0.2>
  clipped_by { box { -1, 1 } }
  rotate x*60 translate y pigment { color rgb <0.5, 0.4, 0.8> }
}
