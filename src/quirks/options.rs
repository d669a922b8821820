//! Command line and INI files.

use super::{Quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "animation_clock",
        "`clock` is computed with 32 bits: it is 0.181818187 in the third of twelve frames. `clock_delta`, `initial_clock` and `final_clock` have \
         six digits.",
        &["src/cli/animation.rs::clocks_have_32_bits", "src/cli/animation.rs::initial_clock_and_delta_have_six_digits"],
    ),
    emulated_quirk(
        "animation_of_one_frame",
        "`+KFI1 +KFF1` renders a single picture, while `+KFF1` alone renders one frame with a number in its file name.",
        &["src/cli/povray/tests.rs::animations"],
    ),
    emulated_quirk(
        "ini_syntax",
        "The rest of a line after the value of a setting is ignored, and quotes are removed wherever they are in a word.",
        &["src/cli/povray/ini.rs::ignored_text_is_reported", "src/cli/povray/ini.rs::quotes_keep_spaces_in_a_word"],
    ),
    emulated_quirk(
        "option_numbers",
        "The number of an option ends at the first character that does not belong to a number, and the rest is ignored: `Height=693.0412871` is \
         693.",
        &["src/cli/povray/number.rs::whole_numbers", "src/cli/povray/number.rs::real_numbers"],
    ),
    emulated_quirk(
        "region_bounds",
        "`+SC`, `+EC`, `+SR` and `+ER` above 1 count pixels from 1; up to 1 they are fractions of the side, but a start of 1 is the first pixel.",
        &["src/cli/povray/tests.rs::size_region_and_format"],
    ),
];
