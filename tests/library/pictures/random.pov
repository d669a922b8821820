// Spheres that the streams of rand.inc place, in different distributions.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "rand.inc"

camera { location <0, 0.5, -9> look_at 0 angle 50 right 4/3*x }
light_source { <4, 9, -8>, White }
background { Gray20 }
#default { finish { ambient 0.2 diffuse 0.7 } }

#macro Ball(At, Radius, Shown) sphere { At, Radius pigment { color Shown } } #end
#for (I, 1, 25)
  Ball(VRand_In_Box(<-4, -2.6, 2>, <-1.5, 2.6, 3>, RdmA), RRand(0.1, 0.3, RdmB), rgb VRand(RdmA))
  Ball(2.2*VRand_On_Sphere(RdmC) + 4*z, 0.25, Scarlet)
  Ball(1.2*VRand_In_Sphere(RdmD) + <2.8, 1.3, 0>, 0.15, SkyBlue*(0.6 + 0.4*rand(RdmD)))
  Ball(<Rand_Normal(2.8, 0.4, RdmB), Rand_Gauss(-1.2, 0.5, RdmB), SRand(RdmA)>, 0.14, GreenYellow)
#end
#declare Apple = difference { sphere { <-2.8, -1, 0>, 1 } box { <-2.8, -1, -2>, <-1, 1, 2> } }
#for (I, 1, 20)
  Ball(VRand_In_Obj(Apple, RdmD), 0.12, select(Prob(0.4, RdmA), 0, 0, 1)*OrangeRed + 0.2)
#end
#for (I, 0, 12)
  Ball(<-3.6 + 0.6*I, -2.9, -1>, 0.06 + 0.05*min(4, Rand_Poisson(1.5, RdmC)), Gold)
  Ball(<-3.6 + 0.6*I, 3 - 0.2*Rand_Exp(1, RdmB), -1>, 0.05 + 0.1*Rand_Beta(2, 3, RdmC), Plum)
#end
