#version 3.7;
global_settings { assumed_gamma 1 }
// Heights of a function just below a 16-bit step: in single precision they reach the step. A step is a tenth of the brightness.
#declare Step = 1/65536;
camera { orthographic location <.5, 5, .5> look_at <.5, 0, .5> right x up .75*y }
height_field {
    function 9, 9 { (floor(x*8 + .5)*3 + floor(y*8 + .5))*Step*(1 - 1e-9) }
    pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } scale 40*Step translate -.5*Step*y } finish { ambient 0 diffuse 0 emission 1 }
}
