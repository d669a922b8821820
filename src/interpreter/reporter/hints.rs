//! Hints about words of other tools, of POV-Ray 3.8 and of other blocks.

/// Returns a hint for a macro or an include file of POV-Ray 3.8 that 3.7 lacks.
pub fn povray_3_8_name_hint(name: &str) -> Option<&'static str> {
    Some(match name.to_lowercase().as_str() {
        "cie.inc" => "part of POV-Ray 3.8; durer reads the include files of 3.7: put the file next to the scene",
        "get_screen_xy" | "get_xy_relative_to_screen" => {
            "part of POV-Ray 3.8, whose screen.inc declares it; durer reads the include files of 3.7"
        }
        _ => return None,
    })
}

/// Returns a hint about the place of a block that can neither stand alone nor be declared; `None` for another block.
pub fn block_place_hint(word: &str) -> Option<&'static str> {
    Some(match word {
        "radiosity" => "it belongs inside `global_settings { … }`",
        "photons" => "it belongs inside `global_settings { … }`, an object or a `light_source`",
        "subsurface" => "it belongs inside `finish { … }` or `global_settings { … }`",
        "warp" => "it belongs inside a `pigment`, `normal`, `texture` or `density`, after the pattern",
        "pattern" => "it belongs inside a function: `#declare F = function { pattern { bozo } }`",
        "texture_list" => "it belongs inside `mesh2 { … }`",
        _ => return None,
    })
}

/// Returns a hint for a word that POV-Ray's language lacks, but that other tools have.
pub fn other_tool_hint(word: &str) -> Option<&'static str> {
    Some(match word.to_lowercase().as_str() {
        "cube" | "cuboid" => "a box is `box { <corner>, <opposite corner> }`",
        "vec3" | "vec2" | "vector" | "point3" => "a vector is `<x, y, z>`",
        "fov" => "POV-Ray's camera has `angle`; the lecture's has `fov_x` and `fov_y`",
        "ellipsoid" => "a `sphere` with a `scale` is an ellipsoid",
        "material_color" | "diffusecolor" | "albedo_color" => "colours are given by `pigment { color rgb <r, g, b> }`",
        "hsv" | "hsl" => "`CHSV2RGB` and `CHSL2RGB` of colors.inc convert such colours",
        "import" | "require" | "use" => "other files are read by `#include \"name.inc\"`",
        "let" | "var" | "const" | "def" | "set" => "names get values by `#declare Name = value;` or `#local`",
        "blend_mode" | "blend_gamma" => {
            "this is of POV-Ray 3.8; durer blends colour components without gamma, as 3.7 does"
        }
        "lemon" | "user_defined" | "akima_spline" | "tcb_spline" | "basic_x_spline" | "extended_x_spline"
        | "general_x_spline" | "oren_nayar" | "lommel_seeliger" | "potential" => {
            "this is part of POV-Ray 3.8; durer renders what 3.7 has"
        }
        "halo" => {
            "POV-Ray 3.1 replaced `halo` by media: write `hollow interior { media { emission 0.5 density { spherical } } }`, with \
             `emission` for `emitting` and `glowing`, `absorption` for `attenuating`, `scattering { 1, 0.5 }` for `dust`"
        }
        "atmosphere" => {
            "POV-Ray 3.1 replaced `atmosphere` by media: write `media { scattering { 1, 0.02 } }`, with the same number of the type"
        }
        "func" | "fn" | "proc" => "`#macro Name(A, B) … #end` defines a macro",
        "rotation" | "rotatex" | "rotatey" | "rotatez" => "`rotate <x, y, z>` takes degrees",
        "and" => "the logical and is `&`",
        "or" => "the logical or is `|`",
        "not" => "the logical not is `!`",
        "position" | "pos" | "move" => "`translate <x, y, z>` moves an object",
        "size" | "resize" => "`scale` changes an object's size",
        "light" | "pointlight" | "point_light" => "a light is `light_source { <location>, color }`",
        "group" | "compound" | "object_group" => "`union { … }` puts objects together",
        "subtract" | "minus" => "`difference { A B }` takes B away from A",
        "intersect" => "`intersection { A B }` keeps what both share",
        "colour_rgb" | "rgba" => "`rgbt <r, g, b, t>` has a fourth number for the transparency",
        "diffuse_color" | "kd" | "ks" => "`finish { diffuse … specular … }` sets how a surface reflects light",
        "if" | "while" | "for" | "else" | "end" | "macro" | "include" | "declare" | "local" | "version" | "debug" => {
            "directives begin with `#`"
        }
        _ => return None,
    })
}

/// Returns a hint for a word that has another name in this block, or that belongs to another block.
pub fn wrong_block_word_hint(block: &str, word: &str) -> Option<&'static str> {
    Some(match (block, word.to_lowercase().as_str()) {
        ("camera", "position" | "pos" | "from" | "origin" | "place") => {
            "`location <x, y, z>` sets the position of a camera"
        }
        ("camera", "target" | "lookat" | "at" | "to" | "direction_to") => {
            "`look_at <x, y, z>` sets the point in the middle of the picture"
        }
        ("camera", "zoom" | "focal_length") => "`angle` sets the field of view in degrees",
        ("light_source", "position" | "location" | "pos") => {
            "a light's position comes first: `light_source { <x, y, z>, color }`"
        }
        ("light_source", "intensity" | "power" | "brightness") => "a light is as bright as its colour: `rgb 2`",
        ("finish", "shininess" | "gloss" | "glossiness") => "`phong_size` or `roughness` sets the size of a highlight",
        ("finish", "reflective" | "reflectivity" | "mirror") => "`reflection { 0.5 }` sets how much a surface reflects",
        ("finish", "color" | "colour" | "rgb") => "a colour belongs in a pigment: `pigment { rgb <r, g, b> }`",
        ("pigment", "transparency" | "alpha" | "opacity") => {
            "`rgbt <r, g, b, t>` has a fourth number for the transparency"
        }
        ("pigment", "texture" | "image" | "map") => "a picture is applied by `image_map { png \"name.png\" }`",
        ("texture" | "interior" | "material", "color" | "colour" | "rgb") => {
            "a colour belongs in a pigment: `pigment { rgb <r, g, b> }`"
        }
        _ => return None,
    })
}
