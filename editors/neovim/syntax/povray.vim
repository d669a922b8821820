" Made of durer's tables by `UPDATE_EDITORS=1 cargo test --test suite editors::`: change those.
if exists('b:current_syntax')
  finish
endif
syntax case match
syntax iskeyword @,48-57,_

syntax keyword povrayObject bicubic_patch blob box cone cubic cylinder difference disc height_field intersection isosurface
syntax keyword povrayObject julia_fractal lathe merge mesh mesh2 object ovus parametric plane poly polygon polynomial prism
syntax keyword povrayObject quadric quartic smooth_triangle sor sphere sphere_sweep superellipsoid text torus triangle union
syntax keyword povrayBlock array bokeh bounded_by bump_map camera clipped_by color_map colour_map composite contained_by default
syntax keyword povrayBlock density density_map exterior face_indices finish fog function global_settings image_map interior
syntax keyword povrayBlock interior_texture irid light_group light_source looks_like material material_map matrix media
syntax keyword povrayBlock mesh_camera normal normal_indices normal_map normal_vectors pattern photons pigment pigment_map
syntax keyword povrayBlock precompute projected_through pwr radiosity rainbow reflection scattering sky_sphere slope_map
syntax keyword povrayBlock subsurface texture texture_list texture_map tiles transform uv_indices uv_vectors vertex_vectors warp
syntax keyword povrayBlock xyz
syntax keyword povrayFunction abs acos acosh asc asin asinh atan atan2 atanh bitwise_and bitwise_or bitwise_xor ceil chr concat cos
syntax keyword povrayFunction cosh cube datetime defined degrees dimension_size dimensions div exp file_exists floor inside int
syntax keyword povrayFunction internal ln log max max_extent min min_extent mod pow prod radians rand seed select sin sinh sqr sqrt
syntax keyword povrayFunction str strcmp strlen strlwr strupr substr sum tan tanh trace val vaxis_rotate vcross vdot vlength
syntax keyword povrayFunction vnormalize vrotate vstr vturbulence
syntax keyword povrayConstant clock clock_delta clock_on false final_clock final_frame frame_number image_height image_width
syntax keyword povrayConstant initial_clock initial_frame input_file_name no now off on pi t true u v version x y yes z
syntax keyword povrayWord aa_level aa_threshold absorption accuracy adaptive adc_bailout agate agate_turb albedo all
syntax keyword povrayWord all_intersections alpha altitude always_sample ambient ambient_light angle aoi aperture append
syntax keyword povrayWord arc_angle area_illumination area_light ascii assumed_gamma autostop average b_spline background
syntax keyword povrayWord bezier_spline black_hole blue blur_samples bmp boxed bozo brick brick_size brightness brilliance
syntax keyword povrayWord bump_size bumps caustics cells charset checker circular collect color colour component confidence
syntax keyword povrayWord conic_sweep conserve_energy control0 control1 coords count crackle crand cubic_spline cubic_wave
syntax keyword povrayWord cutaway_textures cylindrical declare density_file dents deprecated df3 diffuse direction dispersion
syntax keyword povrayWord dispersion_samples dist_exp distance double_illuminate eccentricity emission error_bound evaluate
syntax keyword povrayWord expand_thresholds exponent exr extinction facets fade_color fade_colour fade_distance fade_power
syntax keyword povrayWord falloff falloff_angle filter fisheye flatness flip focal_point fog_alt fog_offset fog_type form
syntax keyword povrayWord frequency fresnel gamma gather gif global_lights gradient granite gray gray_threshold green hdr
syntax keyword povrayWord hexagon hf_gray_16 hierarchy hollow hypercomplex iff image_pattern importance include inside_vector
syntax keyword povrayWord interpolate intervals inverse ior irid_wavelength jitter jpeg julia lambda leopard linear_spline
syntax keyword povrayWord linear_sweep load_file location look_at low_error_factor magnet major_radius mandel map_type marble
syntax keyword povrayWord max_gradient max_intersections max_iteration max_sample max_trace max_trace_level maximum_reuse
syntax keyword povrayWord media_attenuation media_interaction metallic method metric minimum_reuse mm_per_unit mortar
syntax keyword povrayWord natural_spline nearest_count no_bump_scale no_image no_radiosity no_reflection no_shadow
syntax keyword povrayWord noise_generator number_of_sides number_of_tiles number_of_waves octaves offset omega omnimax once
syntax keyword povrayWord onion open orient orientation orthographic panoramic parallel pass_through pavement perspective pgm
syntax keyword povrayWord phase phong phong_size pigment_pattern planar png point_at poly_wave pot ppm precision premultiplied
syntax keyword povrayWord pretrace_end pretrace_start quadratic_spline quaternion quick_color quick_colour quilted radial
syntax keyword povrayWord radius ramp_wave ratio read reciprocal recursion_limit red reflection_exponent refraction repeat rgb
syntax keyword povrayWord rgbf rgbft rgbt right ripples rotate roughness samples save_file scale scallop_wave shadowless
syntax keyword povrayWord sine_wave sint16be sint16le sint32be sint32le sint8 size sky slice slope smooth solid spacing
syntax keyword povrayWord specular spherical spiral1 spiral2 spline split_union spotlight spotted square srgb srgbf srgbft
syntax keyword povrayWord srgbt strength sturm sys target tga thickness threshold tiff tightness tile2 tiling tolerance
syntax keyword povrayWord toroidal translate translucency transmit triangle_wave triangular ttf turb_depth turbulence type
syntax keyword povrayWord u_steps uint16be uint16le uint8 ultra_wide_angle up use_alpha use_color use_colour use_index utf8
syntax keyword povrayWord uv_mapping v_steps variance water_level waves width wood wrinkles write

syntax match povrayNumber /\%(\<\d\+\%(\.\d*\)\=\|\.\d\+\)\%([eE][-+]\=\d\+\)\=\>\=/
syntax match povrayDeclared /\<\h\w*\>/ contained
syntax match povrayMacro /\<\h\w*\>/ contained nextgroup=povrayParameters skipwhite skipnl
syntax region povrayParameters start=/(/ end=/)/ contained contains=povrayParameter,povrayComment,povrayOptional
syntax match povrayParameter /\<\h\w*\>/ contained
syntax keyword povrayOptional optional contained
syntax match povrayDirective /#[ \t]*\%(break\|case\|debug\|declare\|default\|else\|elseif\|end\|error\|fclose\|fopen\|for\|if\|ifdef\|ifndef\|include\|local\|macro\|range\|read\|render\|statistics\|switch\|undef\|version\|warning\|while\|write\)\>/
syntax match povrayDirective /#[ \t]*\%(declare\|local\)\>/ nextgroup=povrayDeclared skipwhite skipnl
syntax match povrayDirective /#[ \t]*macro\>/ nextgroup=povrayMacro skipwhite skipnl
syntax match povrayDirective /#[ \t]*for\>\ze\s*(/ nextgroup=povrayCounter skipwhite
syntax match povrayCounter /(\s*\h\w*/ contained contains=povrayDeclared

syntax keyword povrayTodo TODO FIXME XXX contained
syntax region povrayString start=/"/ skip=/\\./ end=/"/ contains=povrayEscape
syntax match povrayEscape /\\\%(u\x\{4}\|.\)/ contained
syntax match povrayComment +//.*$+ contains=povrayTodo,@Spell
" They nest.
syntax region povrayComment start=+/\*+ end=+\*/+ contains=povrayComment,povrayTodo,@Spell
syntax sync fromstart

highlight default link povrayObject Type
highlight default link povrayBlock Structure
highlight default link povrayFunction Function
highlight default link povrayConstant Constant
highlight default link povrayWord Statement
highlight default link povrayNumber Number
highlight default link povrayDirective PreProc
highlight default link povrayDeclared Identifier
highlight default link povrayMacro Macro
highlight default link povrayParameter Identifier
highlight default link povrayOptional PreProc
highlight default link povrayString String
highlight default link povrayEscape SpecialChar
highlight default link povrayComment Comment
highlight default link povrayTodo Todo

let b:current_syntax = 'povray'
