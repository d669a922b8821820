// `uv_mapping` of a mesh, or of a group around it, holds for textures of its triangles too; those of a mesh that says so itself are not moved.
#version 3.7;
#include "csg.inc"
#declare M = mesh { triangle { <-1, 0, 0>, <1, 0, 0>, <0, 1.4, .6> uv_vectors <0, 0>, <1, 0>, <0, 1> texture { TC } } triangle { <-1, 0, 0>, <1, 0, 0>, <0, -1, .2> texture { TB } } }
mesh { triangle { <-1, 0, 0>, <1, 0, 0>, <0, 1.4, .6> uv_vectors <0, 0>, <1, 0>, <0, 1> texture { TC } } triangle { <-1, 0, 0>, <1, 0, 0>, <0, -1, .2> uv_vectors <0, 0>, <2, 0>, <0, 2> } uv_mapping texture { TG } rotate 20 translate <-1.1, .3, 0> }
union { object { M rotate 30*y translate <1.1, .4, 0> } uv_mapping rotate 5*z }
