//! Words that people bring along from other tools.

/// What to say about a word that is unknown here and known elsewhere.
pub(super) fn other_tools(word: &str) -> Option<&'static str> {
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
            "this is of POV-Ray 3.8; durer blends the numbers of colours as they are, as 3.7 does"
        }
        "func" | "fn" | "proc" => "`#macro Name(A, B) … #end` defines a macro",
        "rotation" | "rotatex" | "rotatey" | "rotatez" => "`rotate <x, y, z>` takes degrees",
        "position" | "pos" | "move" => "`translate <x, y, z>` moves an object",
        "size" | "resize" => "`scale` changes an object's size",
        "light" | "pointlight" | "point_light" => "a light is `light_source { <location>, color }`",
        "group" | "compound" | "object_group" => "`union { … }` puts objects together",
        "subtract" | "minus" => "`difference { A B }` takes B away from A",
        "intersect" => "`intersection { A B }` keeps what both share",
        "colour_rgb" | "rgba" => "`rgbt <r, g, b, t>` has a fourth number for how much passes",
        "diffuse_color" | "kd" | "ks" => "`finish { diffuse … specular … }` says how a surface answers to light",
        "if" | "while" | "for" | "else" | "end" | "macro" | "include" | "declare" | "local" | "version" | "debug" => {
            "directives begin with `#`"
        }
        _ => return None,
    })
}

/// The standard include file that declares a name (manual, "Include files"), for the names that are forgotten most.
pub(super) fn include_of(name: &str) -> Option<&'static str> {
    INCLUDES.iter().find(|(_, names)| names.contains(&name)).map(|(file, _)| *file)
}

const INCLUDES: &[(&str, &[&str])] = &[
    (
        "colors.inc",
        &[
            "Red",
            "Green",
            "Blue",
            "Yellow",
            "Cyan",
            "Magenta",
            "Clear",
            "White",
            "Black",
            "Gray25",
            "Gray50",
            "Gray75",
            "Orange",
            "Brown",
            "Pink",
            "Violet",
            "Gold",
            "Silver",
            "SkyBlue",
            "Navy",
            "NavyBlue",
            "ForestGreen",
        ],
    ),
    ("textures.inc", &["Glass", "Glass3", "Chrome_Metal", "Chrome_Texture", "Cork", "Jade", "DMFWood1", "DMFWood4"]),
    ("woods.inc", &["T_Wood1", "T_Wood2", "T_Wood3", "T_Wood10"]),
    ("stones.inc", &["T_Stone1", "T_Stone2", "T_Stone10", "T_Grnt1"]),
    ("metals.inc", &["T_Brass_1A", "T_Chrome_1A", "T_Copper_1A", "T_Silver_1A"]),
    ("golds.inc", &["T_Gold_1A", "T_Gold_1B"]),
    ("skies.inc", &["S_Cloud1", "S_Cloud2"]),
    ("finish.inc", &["Dull", "Shiny", "Phong_Shiny", "Luminous", "Mirror", "Glossy", "Metal"]),
];
