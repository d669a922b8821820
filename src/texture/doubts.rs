//! Warnings about values of a texture that are valid but probably a mistake; they are rendered as written.

use super::blend::Map;
use crate::color::Color;
use crate::diagnostic::{Diagnostic, codes};
use crate::source::Span;
use crate::value::Reader;

/// Brightness of a colour above which the warning W0406 is considered.
const BRIGHT: f64 = 20.0;
/// Largest value of a colour's channel in painting programs.
const BYTE: f64 = 255.0;

/// Warns of a colour in numbers from 0 to 255 (W0406): all are whole, and one is above [`BRIGHT`]. A colour with equal
/// numbers below 255, or with a number above 255, is taken as that of a lamp that is meant to be bright.
pub fn warn_if_color_in_bytes(r: &mut dyn Reader, at: Span, color: &Color) {
    let c = color.rgb;
    let whole = [c.x, c.y, c.z].iter().all(|x| (0.0..=BYTE).contains(x) && x.fract() == 0.0);
    let gray = c.x == c.y && c.y == c.z && c.x != BYTE;
    if !whole || gray || c.max_element() <= BRIGHT {
        return;
    }
    let typed = format!("<{}, {}, {}>", c.x, c.y, c.z);
    let message = format!("the colour `rgb {typed}` is far brighter than white: colours go from 0 to 1");
    let help = format!("write `srgb {typed}/255` for what painting programs call so, or `rgb {typed}/255`");
    r.report(Diagnostic::new(codes::COLOR_OF_BYTES, at, message).help(help));
}

/// Warns of a map whose numbers descend (W0409).
pub fn warn_if_map_descends<T>(r: &mut dyn Reader, at: Span, map: &Map<T>) {
    let falls = map.entries.windows(2).find(|pair| pair[1].0 < pair[0].0 - 1e-6 * pair[0].0.abs().max(1e-3));
    let Some([(before, _), (number, _)]) = falls else { return };
    let message = format!("the numbers of this map fall: {number} comes after {before}");
    let help = "the entries go from the smallest number to the largest, as in `[0 …] [1 …]`";
    r.report(Diagnostic::new(codes::FALLING_MAP, at, message).help(help));
}
