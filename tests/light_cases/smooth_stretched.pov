#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> direction z*10 right x*4 up y*3 }
light_source { <-3, 5, -8> rgb 1 }
// Normals have length 1 after all transforms, and what lies between them is their mean.
smooth_triangle { <-1, -1, 0>, <-.8, -.5, -1>, <1, -1, 0>, <.8, -.3, -1>, <0, 1, 0>, <0, 3, -1>
  pigment { rgb <.9, .6, .4> } finish { specular .8 roughness .02 } scale <2, 1.2, .4> }
