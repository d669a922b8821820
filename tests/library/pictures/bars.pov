// Arrays sorted, reversed and counted, numbers and strings: as bars, and as what Parse_String makes of text.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "math.inc"
#include "arrays.inc"
#include "strings.inc"
#include "rand.inc"

camera { location <8, 6, -1000> right 16*x up 12*y direction 1000*z }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#macro Bar(I, Row, Height, Shown) box { <I, 2*Row, 0>, <I + 0.8, 2*Row + Height, 1> pigment { color Shown } } #end

#declare Stream = seed(7);
#declare A = array[16];
#for (I, 0, 15) #declare A[I] = 0.1 + 1.7*rand(Stream); #end
#for (I, 0, 15) Bar(I, 0, A[I], Gray60) #end
Sort_Partial_Array(A, 3, 12)
#for (I, 0, 15) Bar(I, 1, A[I], Orange) #end
Sort_Array(A)
Reverse_Array(A)
#for (I, 0, 15) Bar(I, 2, A[I], ForestGreen) #end
#declare B = array[200];
#for (I, 0, 199) #declare B[I] = Rand_Gauss(0, 1, RdmA); #end
// POV-Ray 3.7 finds the size under this name only.
#declare N = 200;
Histogram(B, 16)
#for (I, 0, 15) Bar(I, 3, HistogramArray[I][1]/31, SteelBlue) #end
GetStats(B)
#for (I, 0, 4) Bar(I, 4, min(1.8, 0.3 + abs(StatisticsArray[I])/4), Firebrick) #end
#for (I, 5, 10) Bar(I, 4, Interpolate(I, 5, 10, 0.1, 1.8, select(I - 8, 0, 1, 3)), Plum) #end
Bar(11, 4, 1 + 0.8*sind(40), Gold)
Bar(12, 4, clamp(7.3, 0.5, 1.5), Gold)
Bar(13, 4, adj_range(even(4)*0.3 + 0.2, 0.5, 1.5), Gold)
Bar(14, 4, VDist(<0.1, 0.2, 0.3>, <0.9, 0.7, 0.1>), Gold)
Bar(15, 4, VRotation(x, <1, 2, 0>, z), Gold)
#for (I, 0, 7)
  Parse_String(concat(
    "object { ",
    Triangle_Str(<I, 10, 0>, <I + 0.9, 10, 0>, VRotation(x, y, z)*<0, 1, 0> + <I + 0.1*I, 10.2, 0>),
    " pigment { ", CRGBStr(<I/7, 0.5, 1 - I/7>, 0, 3), " } }"
  ))
  Parse_String(concat(
    "sphere { ", VStr(<I + 8.5, 11, 0>), ", ", Str(0.2 + 0.03*I), " pigment { ", CRGBFTStr(<1, I/7, 0.2, 0, 0>, 0, 3), " } }"
  ))
#end
