#declare Post = box { <-0.3, 0, -0.3>, <0.3, 1, 0.3> pigment { srgb <0.6, 0.4, 0.2> } }
object { Post translate -2*x }
object { Post scale <1, 2, 1> }
object { Post rotate -30*z translate 2*x }
