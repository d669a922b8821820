//! Formatting of numbers without superfluous digits.

/// Formats a number with at most `max_decimals` decimals, without trailing zeros and without the sign of a zero.
pub fn format_decimal(x: f64, max_decimals: usize) -> String {
    let text = format!("{x:.max_decimals$}");
    match trim_zeros(&text) {
        "-0" => "0".into(),
        short => short.into(),
    }
}

/// Removes the trailing zeros of a formatted number's fraction.
pub fn trim_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn trailing_zeros_and_the_sign_of_zero_are_omitted() {
        let cases = [(1.5, 3, "1.5"), (100.0, 0, "100"), (-0.0001, 2, "0"), (-2.0, 2, "-2"), (0.127, 2, "0.13")];
        for (x, digits, text) in cases {
            assert_eq!(format_decimal(x, digits), text);
        }
    }
}
