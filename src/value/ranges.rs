//! Readers of numbers that have to be within a range.

use super::Reader;
use crate::diagnostic::{Diagnostic, Result, codes};
use std::ops::RangeInclusive;

/// Reads the number after `word`, which has to be more than 0.
///
/// # Errors
/// E0209 at the number if it is not.
pub fn positive(word: &str, r: &mut dyn Reader) -> Result<f64> {
    read_checked(word, "more than 0", |value| value > 0.0 && value.is_finite(), r)
}

/// Reads the number after `word`, which has to be more than 0 and at most 1.
///
/// # Errors
/// E0209 at the number if it is not.
pub fn positive_up_to_one(word: &str, r: &mut dyn Reader) -> Result<f64> {
    read_checked(word, "more than 0 and at most 1", |value| value > 0.0 && value <= 1.0, r)
}

/// Reads the number after `word`, which has to be at least 0.
///
/// # Errors
/// E0209 at the number if it is not.
pub fn not_negative(word: &str, r: &mut dyn Reader) -> Result<f64> {
    read_checked(word, "at least 0", |value| value >= 0.0, r)
}

/// Reads the number after `word`, which has to be in `range`.
///
/// # Errors
/// E0209 at the number if it is not.
pub fn in_range(word: &str, range: RangeInclusive<f64>, r: &mut dyn Reader) -> Result<f64> {
    let text = format!("from {} to {}", range.start(), range.end());
    read_checked(word, &text, |value| range.contains(&value), r)
}

/// Reads the number after `word`, rounded down, which has to be from 1 to `most`.
///
/// # Errors
/// E0209 at the number if it is not.
pub fn whole_from_one(word: &str, most: u32, r: &mut dyn Reader) -> Result<u32> {
    let is_valid = |value: f64| (1.0..f64::from(most) + 1.0).contains(&value);
    read_checked(word, &format!("a whole number from 1 to {most}"), is_valid, r).map(|value| value as u32)
}

fn read_checked(word: &str, range_text: &str, is_valid: impl Fn(f64) -> bool, r: &mut dyn Reader) -> Result<f64> {
    let (at, value) = (r.span(), r.float()?);
    if is_valid(value) {
        return Ok(value);
    }
    Diagnostic::err(codes::BAD_ARGUMENT, at, format!("`{word}` has to be {range_text}, found {value}"))
}
