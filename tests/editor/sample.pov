// all of it
/* sphere in a comment /* nested */ still a comment */
#version 3.7;
#declare Size = 1.5e-1;
#macro Ball (Where, Big)
  sphere { Where, Big
    pigment { rgb <1, sin(2 * pi), .5> }
  }
#end
#for (Index, 1, 3)
  Ball (x, Index * Size)
# end
#debug "a // text \" with /* in it"
union {
  #if (Size > 1)
    box {
      0, 1
    }
  #else
    object { Unknown }
  #end
  rotate 90 * y
}
#unknown
