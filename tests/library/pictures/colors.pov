// Every colour of colors.inc as a tile of three by four pixels, then hues by CHSL2RGB and CHSV2RGB, and one pushed around by the inverses.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"

camera { location <7.5, 4, -1000> right 16*x up 9*y direction 1000*z }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#macro Tile(I, Shown)
  box { <-0.5, -0.5, 0>, <0.5, 0.5, 1> pigment { color Shown } translate <mod(I, 16), 8 - int(I/16), 0> }
#end

#declare Names = array[127] {
  Red, Green, Blue, Yellow, Cyan, Magenta, White, Black, Gray05, Gray10, Gray15, Gray20, Gray25, Gray30, Gray35,
  Gray40, Gray45, Gray50, Gray55, Gray60, Gray65, Gray70, Gray75, Gray80, Gray85, Gray90, Gray95, Aquamarine,
  BakersChoc, BlueViolet, Brass, BrightGold, Bronze, Bronze2, Brown, CadetBlue, CoolCopper, Copper, Coral,
  CornflowerBlue, DarkBrown, DarkGreen, DarkOliveGreen, DarkOrchid, DarkPurple, DarkSlateBlue, DarkSlateGray,
  DarkSlateGrey, DarkTan, DarkTurquoise, DarkWood, DimGray, DimGrey, DkGreenCopper, DustyRose, Feldspar, Firebrick,
  Flesh, ForestGreen, Gold, Goldenrod, Gray, GreenCopper, GreenYellow, Grey, HuntersGreen, IndianRed, Khaki,
  LightBlue, LightGray, LightGrey, LightSteelBlue, LightWood, Light_Purple, LimeGreen, MandarinOrange, Maroon,
  Med_Purple, MediumAquamarine, MediumBlue, MediumForestGreen, MediumGoldenrod, MediumOrchid, MediumSeaGreen,
  MediumSlateBlue, MediumSpringGreen, MediumTurquoise, MediumVioletRed, MediumWood, Mica, MidnightBlue, Navy,
  NavyBlue, NeonBlue, NeonPink, NewMidnightBlue, NewTan, OldGold, Orange, OrangeRed, Orchid, PaleGreen, Pink, Plum,
  Quartz, RichBlue, Salmon, Scarlet, SeaGreen, SemiSweetChoc, Sienna, Silver, SkyBlue, SlateBlue, SpicyPink,
  SpringGreen, SteelBlue, SummerSky, Tan, Thistle, Turquoise, VeryDarkBrown, Very_Light_Purple, Violet, VioletRed,
  Wheat, YellowGreen
}
#for (I, 0, 126)
  Tile(I, Names[I])
#end
#for (I, 0, 16)
  #local Hue = 720*I/17;
  #switch (mod(I, 3))
    #case (0) Tile(127 + I, rgb CHSL2RGB(<Hue, 0.7, 0.3 + 0.02*I>)) #break
    #case (1) Tile(127 + I, rgb CHSV2RGB(<Hue, 0.6, 0.9>)) #break
    #else
      #local Back = CRGB2HSV(Names[20 + I]);
      Tile(127 + I, rgb CHSV2RGB(<mod(Back.x + 180, 360), Back.y/2, Back.z>))
  #end
#end
