// x³ + y³ + z³ = 0.5
cubic {
  <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -0.5>
  clipped_by { sphere { 0, 1.4 } }
  rotate y*60 translate <0, 1, 0> pigment { color rgb <0.3, 0.6, 0.4> }
}
