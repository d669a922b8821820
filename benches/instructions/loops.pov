// Loops, arrays, strings and macros of the scene language.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5 * z }
#declare Found = array[1000];
#declare Sum = 0;
#for (I, 0, 99999)
  #declare Sum = Sum + mod(I * I, 7) * vlength(<I, 1, 2>);
  #declare Found[mod(I, 1000)] = Sum;
#end
#macro Step(A) #if (A > 0.5) #local B = A * 2 - 1; #else #local B = A * 2; #end B #end
#declare A = 0.3;
#for (I, 0, 9999) #declare A = Step(A); #end
#declare Text = "";
#for (I, 0, 999) #declare Text = concat(substr(concat(Text, str(I, 0, 0)), 1, 1), chr(65 + mod(I, 26))); #end
sphere { 0, 1 pigment { rgb mod(Sum, 1) + A } }
