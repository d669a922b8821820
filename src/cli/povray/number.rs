//! Parses numbers in options as POV-Ray does, which ignores the rest after a valid number: `Height=693.0412871` is 693
//! (quirk: `option_numbers`).

/// Parses a whole number: an optional sign and digits at the start. `12.7`, `12abc`, `1,5` and `1e2` end at the first
/// character that is no digit; `abc` and `.5` are no whole numbers.
pub fn parse_whole_prefix(text: &str) -> Option<f64> {
    let end = sign_length(text) + digit_count(&text[sign_length(text)..]);
    text[..end].parse().ok()
}

/// Parses the number at the start of a text: `0.5x` is 0.5, `1e` is 1.
pub fn parse_number_prefix(text: &str) -> Option<f64> {
    let start = sign_length(text);
    let before = start + digit_count(&text[start..]);
    let after = match text[before..].strip_prefix('.') {
        Some(rest) => before + 1 + digit_count(rest),
        None => before,
    };
    let mantissa: f64 = text[..after].parse().ok()?;
    let Some(rest) = text[after..].strip_prefix(['e', 'E']) else { return Some(mantissa) };
    let power = digit_count(&rest[sign_length(rest)..]);
    let end = after + 1 + sign_length(rest) + power;
    if power == 0 { Some(mantissa) } else { text[..end].parse().ok() }
}

/// Returns the length of a number's sign in bytes.
fn sign_length(text: &str) -> usize {
    usize::from(text.starts_with(['+', '-']))
}

/// Returns the number of digits at the start of a text.
fn digit_count(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers() {
        for (text, number) in [("693.0412871", 693.0), ("1e2", 1.0), ("12abc", 12.0), ("1,5", 1.0), ("0x10", 0.0)] {
            assert_eq!(parse_whole_prefix(text), Some(number), "{text}");
        }
        assert_eq!(["+12", "-5", "06"].map(parse_whole_prefix), [Some(12.0), Some(-5.0), Some(6.0)]);
        assert_eq!(["", "abc", ".5e2", "+", "\u{e9}"].map(parse_whole_prefix), [None; 5]);
    }

    #[test]
    fn real_numbers() {
        for (text, number) in [("0.5abc", 0.5), ("1e-1", 0.1), ("-.5", -0.5), ("1e", 1.0), (".5.5", 0.5), ("1,5", 1.0)]
        {
            assert_eq!(parse_number_prefix(text), Some(number), "{text}");
        }
        assert_eq!(["2.", "1e+2x", "+3"].map(parse_number_prefix), [Some(2.0), Some(100.0), Some(3.0)]);
        assert_eq!(["", "abc", ".", "-", "e5", "inf", "nan"].map(parse_number_prefix), [None; 7]);
    }
}
