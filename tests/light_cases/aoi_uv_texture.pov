// Where uv_mapping stands in the texture, a pigment sees the bumps in the texture's space.
#version 3.7; global_settings{assumed_gamma 1}
camera{location <1,2,-6> look_at <0,.2,0> angle 45}
light_source{<3,4,-6> rgb <1,.9,.7>} background{rgb <.4,.5,.9>} #default { finish { ambient .3 } }
sphere { 0,1 texture { uv_mapping pigment { slope y } normal { bumps 1 scale .2 } } rotate 50*x translate <-1.2,.8,0> }
quadric { 1,0,0,-1 texture { uv_mapping pigment { aoi } normal { bumps .5 scale .2 } } scale <1,.6,1> rotate 50*x translate <1.2,.8,0> }
sphere { 0,.8 texture { uv_mapping pigment { slope y } normal { bumps 0 } } rotate 70*x translate <-1.2,-1,0> }
box { -.7,.7 texture { uv_mapping pigment { slope y } normal { uv_mapping bumps 1 scale .2 } } rotate 50*z translate <1.2,-1,0> }
