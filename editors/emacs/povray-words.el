;;; povray-words.el --- Words of POV-Ray's scene language  -*- lexical-binding: t -*-

;;; Commentary:
;; Made of durer's tables by `UPDATE_EDITORS=1 cargo test --test suite editors::`: change those.

;;; Code:

(defconst povray-words-objects
  '("bicubic_patch" "blob" "box" "cone" "cubic" "cylinder" "difference" "disc" "height_field"
    "intersection" "isosurface" "julia_fractal" "lathe" "merge" "mesh" "mesh2" "object" "ovus"
    "parametric" "plane" "poly" "polygon" "polynomial" "prism" "quadric" "quartic" "smooth_triangle"
    "sor" "sphere" "sphere_sweep" "superellipsoid" "text" "torus" "triangle" "union")
  "Objects.")

(defconst povray-words-blocks
  '("array" "bokeh" "bounded_by" "bump_map" "camera" "clipped_by" "color_map" "colour_map" "composite"
    "contained_by" "default" "density" "density_map" "exterior" "face_indices" "finish" "fog" "function"
    "global_settings" "image_map" "interior" "interior_texture" "irid" "light_group" "light_source"
    "looks_like" "material" "material_map" "matrix" "media" "mesh_camera" "normal" "normal_indices"
    "normal_map" "normal_vectors" "pattern" "photons" "pigment" "pigment_map" "precompute"
    "projected_through" "pwr" "radiosity" "rainbow" "reflection" "scattering" "sky_sphere" "slope_map"
    "subsurface" "texture" "texture_list" "texture_map" "tiles" "transform" "uv_indices" "uv_vectors"
    "vertex_vectors" "warp" "xyz")
  "What else has braces.")

(defconst povray-words-functions
  '("abs" "acos" "acosh" "asc" "asin" "asinh" "atan" "atan2" "atanh" "bitwise_and" "bitwise_or"
    "bitwise_xor" "ceil" "chr" "concat" "cos" "cosh" "cube" "datetime" "defined" "degrees"
    "dimension_size" "dimensions" "div" "exp" "file_exists" "floor" "inside" "int" "internal" "ln" "log"
    "max" "max_extent" "min" "min_extent" "mod" "pow" "prod" "radians" "rand" "seed" "select" "sin"
    "sinh" "sqr" "sqrt" "str" "strcmp" "strlen" "strlwr" "strupr" "substr" "sum" "tan" "tanh" "trace"
    "val" "vaxis_rotate" "vcross" "vdot" "vlength" "vnormalize" "vrotate" "vstr" "vturbulence")
  "What takes arguments in parentheses.")

(defconst povray-words-constants
  '("clock" "clock_delta" "clock_on" "false" "final_clock" "final_frame" "frame_number" "image_height"
    "image_width" "initial_clock" "initial_frame" "input_file_name" "no" "now" "off" "on" "pi" "t" "true"
    "u" "v" "version" "x" "y" "yes" "z")
  "Values.")

(defconst povray-words-others
  '("aa_level" "aa_threshold" "absorption" "accuracy" "adaptive" "adc_bailout" "agate" "agate_turb"
    "albedo" "all" "all_intersections" "alpha" "altitude" "always_sample" "ambient" "ambient_light"
    "angle" "aoi" "aperture" "append" "arc_angle" "area_illumination" "area_light" "ascii"
    "assumed_gamma" "autostop" "average" "b_spline" "background" "bezier_spline" "black_hole" "blue"
    "blur_samples" "bmp" "boxed" "bozo" "brick" "brick_size" "brightness" "brilliance" "bump_size"
    "bumps" "caustics" "cells" "charset" "checker" "circular" "collect" "color" "colour" "component"
    "confidence" "conic_sweep" "conserve_energy" "control0" "control1" "coords" "count" "crackle" "crand"
    "cubic_spline" "cubic_wave" "cutaway_textures" "cylindrical" "declare" "density_file" "dents"
    "deprecated" "df3" "diffuse" "direction" "dispersion" "dispersion_samples" "dist_exp" "distance"
    "double_illuminate" "eccentricity" "emission" "error_bound" "evaluate" "expand_thresholds" "exponent"
    "exr" "extinction" "facets" "fade_color" "fade_colour" "fade_distance" "fade_power" "falloff"
    "falloff_angle" "filter" "fisheye" "flatness" "flip" "focal_point" "fog_alt" "fog_offset" "fog_type"
    "form" "frequency" "fresnel" "gamma" "gather" "gif" "global_lights" "gradient" "granite" "gray"
    "gray_threshold" "green" "hdr" "hexagon" "hf_gray_16" "hierarchy" "hollow" "hypercomplex" "iff"
    "image_pattern" "importance" "include" "inside_vector" "interpolate" "intervals" "inverse" "ior"
    "irid_wavelength" "jitter" "jpeg" "julia" "lambda" "leopard" "linear_spline" "linear_sweep"
    "load_file" "location" "look_at" "low_error_factor" "magnet" "major_radius" "mandel" "map_type"
    "marble" "max_gradient" "max_intersections" "max_iteration" "max_sample" "max_trace"
    "max_trace_level" "maximum_reuse" "media_attenuation" "media_interaction" "metallic" "method"
    "metric" "minimum_reuse" "mm_per_unit" "mortar" "natural_spline" "nearest_count" "no_bump_scale"
    "no_image" "no_radiosity" "no_reflection" "no_shadow" "noise_generator" "number_of_sides"
    "number_of_tiles" "number_of_waves" "octaves" "offset" "omega" "omnimax" "once" "onion" "open"
    "orient" "orientation" "orthographic" "panoramic" "parallel" "pass_through" "pavement" "perspective"
    "pgm" "phase" "phong" "phong_size" "pigment_pattern" "planar" "png" "point_at" "poly_wave" "pot"
    "ppm" "precision" "premultiplied" "pretrace_end" "pretrace_start" "quadratic_spline" "quaternion"
    "quick_color" "quick_colour" "quilted" "radial" "radius" "ramp_wave" "ratio" "read" "reciprocal"
    "recursion_limit" "red" "reflection_exponent" "refraction" "repeat" "rgb" "rgbf" "rgbft" "rgbt"
    "right" "ripples" "rotate" "roughness" "samples" "save_file" "scale" "scallop_wave" "shadowless"
    "sine_wave" "sint16be" "sint16le" "sint32be" "sint32le" "sint8" "size" "sky" "slice" "slope" "smooth"
    "solid" "spacing" "specular" "spherical" "spiral1" "spiral2" "spline" "split_union" "spotlight"
    "spotted" "square" "srgb" "srgbf" "srgbft" "srgbt" "strength" "sturm" "sys" "target" "tga"
    "thickness" "threshold" "tiff" "tightness" "tile2" "tiling" "tolerance" "toroidal" "translate"
    "translucency" "transmit" "triangle_wave" "triangular" "ttf" "turb_depth" "turbulence" "type"
    "u_steps" "uint16be" "uint16le" "uint8" "ultra_wide_angle" "up" "use_alpha" "use_color" "use_colour"
    "use_index" "utf8" "uv_mapping" "v_steps" "variance" "water_level" "waves" "width" "wood" "wrinkles"
    "write")
  "All other words of scenes.")

(defconst povray-words-directives
  '("break" "case" "debug" "declare" "default" "else" "elseif" "end" "error" "fclose" "fopen" "for" "if"
    "ifdef" "ifndef" "include" "local" "macro" "range" "read" "render" "statistics" "switch" "undef"
    "version" "warning" "while" "write")
  "What stands behind #.")

(defconst povray-words-openers
  '("for" "if" "ifdef" "ifndef" "macro" "switch" "while")
  "Directives that an #end closes.")

(defconst povray-words-continuers
  '("case" "else" "elseif" "range")
  "Directives between such a one and its #end.")

(defconst povray-words-options
  '("All_Console" "All_File" "Antialias" "Antialias_Depth" "Antialias_Gamma" "Antialias_Threshold"
    "Append_File" "BSP_BaseAccessCost" "BSP_ChildAccessCost" "BSP_IsectCost" "BSP_MaxDepth"
    "BSP_MissChance" "Bits_Per_Color" "Bounding" "Bounding_Method" "Bounding_Threshold" "Buffer_Output"
    "Buffer_Size" "Clock" "Clockless_Animation" "Compression" "Continue_Trace" "Create_Histogram"
    "Create_Ini" "Cyclic_Animation" "Debug_Console" "Debug_File" "Declare" "Display" "Display_Gamma"
    "Dither" "Dither_Method" "Draw_Vistas" "End_Column" "End_Row" "Fatal_Console" "Fatal_Error_Command"
    "Fatal_Error_Return" "Fatal_File" "Field_Render" "File_Gamma" "Final_Clock" "Final_Frame"
    "Frame_Step" "Grayscale_Output" "Height" "High_Reproducibility" "Histogram_Grid_Size"
    "Histogram_Name" "Histogram_Type" "Include_Header" "Initial_Clock" "Initial_Frame" "Input_File_Name"
    "Jitter" "Jitter_Amount" "Library_Path" "Light_Buffer" "Max_Image_Buffer_Memory" "Odd_Field"
    "Output_Alpha" "Output_File_Name" "Output_File_Type" "Output_to_File" "Palette" "Pause_When_Done"
    "Post_Frame_Command" "Post_Frame_Return" "Post_Scene_Command" "Post_Scene_Return" "Pre_Frame_Command"
    "Pre_Frame_Return" "Pre_Scene_Command" "Pre_Scene_Return" "Preview_End_Size" "Preview_Start_Size"
    "Quality" "Radiosity_File_Name" "Radiosity_From_File" "Radiosity_To_File" "Radiosity_Vain_Pretrace"
    "Real_Time_Raytracing" "Remove_Bounds" "Render_Block_Size" "Render_Block_Step" "Render_Console"
    "Render_File" "Render_Pattern" "Sampling_Method" "Split_Unions" "Start_Column" "Start_Row"
    "Statistic_Console" "Statistic_File" "Subset_End_Frame" "Subset_Start_Frame" "Test_Abort"
    "Test_Abort_Count" "User_Abort_Command" "User_Abort_Return" "Verbose" "Version" "Video_Mode"
    "Vista_Buffer" "Warning_Console" "Warning_File" "Warning_Level" "Width" "Work_Threads")
  "Names in INI files.")

(provide 'povray-words)
;;; povray-words.el ends here
