// Thousands of thin components of a blob.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right x*4/3 angle 40 look_at 0 }
light_source { <-4, 5, -7> rgb 1 }
background { rgb <0.3, 0.5, 0.9> }
#declare R = seed(7);
blob {
  threshold 0.1
  #for (I, 1, 8000)
    #local Y = 2 * rand(R) - 1;
    #local Z = 2 * rand(R) - 1;
    cylinder { <-1.2, Y, Z>, <1.2, Y + 0.2 * rand(R) - 0.1, Z>, 0.004, 1 }
  #end
  pigment { rgb <1, 0.4, 0.2> }
}
