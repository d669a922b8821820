// A torus: the order of the numbers is that of the powers x⁴, x³y, x³z, x³, x²y², x²yz …
quartic {
  <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.18, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.82, 0, 0, 0, 0, 1, 0, -2.18, 0, 0.8281>
  rotate x*-40 translate y pigment { color rgb <0.8, 0.5, 0.2> }
}
