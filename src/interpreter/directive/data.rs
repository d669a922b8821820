//! Contents of data files: parses values for `#read`, and formats them for `#write` as text or bytes.

use crate::interpreter::builtin::leading_number_and_length;
use crate::interpreter::evaluator::numbers_of;
use crate::value::{Value, VecN, format_decimal, trim_zeros};

/// Skips blanks, commas and comments; returns the new offset.
pub(super) fn skip_blanks_commas_comments(text: &str, mut at: usize) -> usize {
    loop {
        let rest = &text[at..];
        let blank = rest.len() - rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',').len();
        let comment = match &rest.as_bytes()[blank..] {
            [b'/', b'/', ..] => rest[blank..].find(['\n', '\r']).unwrap_or(rest.len() - blank),
            [b'/', b'*', ..] => rest[blank..].find("*/").map_or(rest.len() - blank, |i| i + 2),
            _ => 0,
        };
        if blank + comment == 0 {
            return at;
        }
        at += blank + comment;
    }
}

/// Parses the number, vector or string at the start of a text, and returns it with its length in bytes; `None` for
/// anything else. The text must not be empty.
pub(super) fn data_value_and_length(text: &str) -> Option<(Value, usize)> {
    match text.as_bytes()[0] {
        b'"' => {
            let end = 1 + closing_quote_offset(&text[1..])?;
            let inner = crate::syntax::unescape(&text[..=end]);
            Some((Value::Text((*inner).into()), end + 1))
        }
        b'<' => {
            let (mut at, mut c) = (1, vec![]);
            loop {
                at = skip_blanks_commas_comments(text, at);
                if text[at..].starts_with('>') {
                    break;
                }
                let (x, length) = leading_number_and_length(&text[at..])?;
                c.push(x);
                at += length;
            }
            (2..=5).contains(&c.len()).then(|| (Value::Vector(VecN::from_slice(&c)), at + 1))
        }
        _ => leading_number_and_length(text).map(|(x, length)| (Value::Float(x), length)),
    }
}

fn closing_quote_offset(text: &str) -> Option<usize> {
    let mut escaped = false;
    text.bytes().position(|b| {
        let ends = b == b'"' && !escaped;
        escaped = b == b'\\' && !escaped;
        ends
    })
}

/// Formats a value as `#write` does; `None` for a value that cannot be written.
pub(super) fn data_bytes(value: &Value, form: Option<Binary>) -> Option<Vec<u8>> {
    if let (Value::Text(text), None) = (value, form) {
        return Some(text.as_bytes().to_vec());
    }
    let v = numbers_of(value)?;
    let all = &v.c[..v.len as usize];
    Some(match (form, all) {
        (Some(form), all) => all.iter().flat_map(|x| form.round_and_encode(*x)).collect(),
        (None, [x]) => format_six_significant_digits(*x).into_bytes(),
        (None, all) => vector_text(all).into_bytes(),
    })
}

/// Formats a vector as POV-Ray does: `<1,2,3> `.
fn vector_text(all: &[f64]) -> String {
    let parts: Vec<String> = all.iter().map(|x| format_six_significant_digits(*x)).collect();
    format!("<{}> ", parts.join(","))
}

/// Formats a number as C's `%g` does: six significant digits, without trailing zeros.
fn format_six_significant_digits(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return match x {
            _ if x.is_nan() => "nan".into(),
            _ if x.is_infinite() => if x > 0.0 { "inf" } else { "-inf" }.into(),
            _ => "0".into(),
        };
    }
    let scientific = format!("{x:.5e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        return format_decimal(x, (5 - exponent) as usize);
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}e{sign}{:02}", trim_zeros(digits), exponent.abs())
}

/// Binary format of integers, such as `uint16be`.
#[derive(Clone, Copy)]
pub(super) struct Binary {
    size: usize,
    signed: bool,
    big_endian: bool,
}

impl Binary {
    pub(super) fn from_word(word: &str) -> Option<Self> {
        let (signed, rest) = match word.strip_prefix("uint") {
            Some(rest) => (false, rest),
            None => (true, word.strip_prefix("sint")?),
        };
        let (bits, big_endian) = match rest.strip_suffix("be") {
            Some(bits) => (bits, true),
            None => (rest.strip_suffix("le").unwrap_or(rest), false),
        };
        let size = match bits {
            "8" => 1,
            "16" => 2,
            "32" => 4,
            _ => return None,
        };
        Some(Self { size, signed, big_endian })
    }

    /// Rounds a number to the nearest integer in the format's range, and encodes it.
    fn round_and_encode(self, x: f64) -> Vec<u8> {
        let values = (1_i64 << (8 * self.size)) as f64;
        let (low, high) = if self.signed { (-values / 2.0, values / 2.0 - 1.0) } else { (0.0, values - 1.0) };
        let bytes = (x.round().clamp(low, high) as i64).to_le_bytes();
        let mut out = bytes[..self.size].to_vec();
        if self.big_endian {
            out.reverse();
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_encoded_in_binary_formats() {
        let bytes = |word, x| Binary::from_word(word).map(|form| form.round_and_encode(x));
        assert_eq!(bytes("uint8", 65.0), Some(vec![65]));
        assert_eq!(bytes("uint8", 300.0), Some(vec![255]));
        assert_eq!(bytes("sint8", -1.7), Some(vec![0xfe]));
        assert_eq!(bytes("uint16be", 258.0), Some(vec![1, 2]));
        assert_eq!(bytes("uint16le", 258.0), Some(vec![2, 1]));
        assert_eq!(bytes("sint16be", -2.0), Some(vec![255, 254]));
        assert_eq!(bytes("sint32le", 5.0), Some(vec![5, 0, 0, 0]));
        assert_eq!(bytes("float", 5.0), None);
    }

    #[test]
    fn numbers_are_formatted_as_by_c() {
        let all = [0.1, 1.23456789, 1e5, 1e6, 1234567.89, 1e300, -2.5e-7, 0.0001, 100.0, 999_999.5];
        let texts: Vec<String> = all.iter().map(|x| format_six_significant_digits(*x)).collect();
        let wanted =
            ["0.1", "1.23457", "100000", "1e+06", "1.23457e+06", "1e+300", "-2.5e-07", "0.0001", "100", "1e+06"];
        assert_eq!(texts, wanted);
    }
}
