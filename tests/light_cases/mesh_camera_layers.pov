#version 3.7;
global_settings { assumed_gamma 1 }
#declare Rows = mesh {
    #for (J, 0, 9) #for (I, 0, 15)
        triangle { <I/4 - 2, 1.5 - J/4, -5>, <I/4 - 1.9, 1.5 - J/4, -5>, <I/4 - 2, 1.6 - J/4, -5 + .003*I> }
    #end #end
}
camera { mesh_camera { 2 0 8 mesh { Rows } mesh { Rows scale <1.1, 1, 1> translate .05*y } } direction -z }
light_source { <2, 4, -6> 1 }
sphere { 0, 1.5 pigment { gradient y scale 4 translate 2*y } }
plane { z, 2 pigment { gradient x scale 20 translate 10*x } }
