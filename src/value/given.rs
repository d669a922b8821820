//! Parsing of values given outside of a scene, as by `--declare NAME=VALUE`: `2.5`, `"text"`, `<1, 2, 3>`, `rgb <1, 0,
//! 0>`.

use super::{Value, VecN};
use crate::color::{Color, transfer};

/// Colour words with the components of `rgbft` that they set.
const COLORS: &[(&str, &[usize])] = &[
    ("rgb", &[0, 1, 2]),
    ("rgbf", &[0, 1, 2, 3]),
    ("rgbt", &[0, 1, 2, 4]),
    ("rgbft", &[0, 1, 2, 3, 4]),
    ("srgb", &[0, 1, 2]),
    ("srgbf", &[0, 1, 2, 3]),
    ("srgbt", &[0, 1, 2, 4]),
    ("srgbft", &[0, 1, 2, 3, 4]),
];

/// Parses the value of a scene's variable that is given on the command line: a number, string, vector or colour.
///
/// # Errors
/// A description of what is wrong with the text.
pub fn parse_value(text: &str) -> Result<Value, String> {
    let text = text.trim();
    if let Some(x) = parse_number(text) {
        return Ok(Value::Float(x));
    }
    if text.len() >= 2 && text.starts_with('"') && text.ends_with('"') {
        return Ok(Value::Text(text[1..text.len() - 1].into()));
    }
    if text.starts_with('<') {
        return parse_vector(text).map(Value::Vector);
    }
    let first = text.split(|c: char| !c.is_ascii_alphanumeric()).next().unwrap_or_default();
    let rest = text[first.len()..].trim_start();
    match first {
        "color" | "colour" if rest.starts_with('<') => parse_color("rgbft", rest),
        "color" | "colour" if !rest.is_empty() => parse_value(rest).and_then(|value| match value {
            Value::Color(_) => Ok(value),
            _ => Err(format!("`{rest}` is no colour, which is written as rgb <1, 0.5, 0>")),
        }),
        _ if COLORS.iter().any(|(word, _)| *word == first) => parse_color(first, rest),
        _ => Err(format!("`{text}` is no number, vector (<1, 2, 3>) or colour (rgb <1, 0, 0>)")),
    }
}

fn parse_number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite())
}

/// Parses a vector of two to five components between `<` and `>`.
fn parse_vector(text: &str) -> Result<VecN, String> {
    let inner = text.strip_prefix('<').and_then(|text| text.strip_suffix('>'));
    let inner = inner.ok_or_else(|| format!("`{text}` is no vector: `>` is missing at its end"))?;
    let parts: Vec<&str> = inner.split(',').collect();
    if !(2..=5).contains(&parts.len()) {
        return Err(format!("`{text}` is no vector, which has 2 to 5 numbers with commas between them: <1, 2, 3>"));
    }
    let read = |part: &&str| parse_number(part).ok_or_else(|| format!("`{}` in `{text}` is no number", part.trim()));
    let numbers = parts.iter().map(read).collect::<Result<Vec<f64>, String>>()?;
    Ok(VecN::from_slice(&numbers))
}

/// Parses a colour: its word and a vector, or one number for all components.
fn parse_color(word: &str, rest: &str) -> Result<Value, String> {
    let slots = COLORS.iter().find(|(name, _)| *name == word).map_or(&[0, 1, 2][..], |(_, slots)| slots);
    let given = match parse_number(rest) {
        Some(x) => VecN::splat(x, slots.len() as u8),
        None if rest.starts_with('<') => parse_vector(rest)?,
        None => return Err(format!("`{word}` needs numbers behind it: {word} <{}>", example_components(slots.len()))),
    };
    // `color <1, 0, 0>` may have fewer components than five.
    if usize::from(given.len) != slots.len() && !(word == "rgbft" && given.len >= 3) {
        let example = example_components(slots.len());
        return Err(format!("`{word}` has {} numbers, not {}: {word} <{example}>", slots.len(), given.len));
    }
    let mut c = [0.0; 5];
    slots.iter().zip(given.c).for_each(|(slot, x)| c[*slot] = x);
    let mut color = Color::from_array(c);
    if word.starts_with('s') {
        color.rgb = transfer::srgb_decode_rgb(color.rgb);
    }
    Ok(Value::Color(color))
}

fn example_components(count: usize) -> &'static str {
    match count {
        3 => "1, 0.5, 0",
        4 => "1, 0.5, 0, 0.3",
        _ => "1, 0.5, 0, 0, 0.3",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(text: &str) -> Vec<f64> {
        match parse_value(text) {
            Ok(Value::Float(x)) => vec![x],
            Ok(Value::Vector(v)) => v.c[..usize::from(v.len)].to_vec(),
            Ok(Value::Color(c)) => c.to_array().to_vec(),
            other => panic!("{text}: {other:?}"),
        }
    }

    #[test]
    fn numbers_vectors_colors_and_strings_are_parsed() {
        assert_eq!(numbers("-2.5e1"), [-25.0]);
        assert_eq!(numbers("<1, -2,3e0>"), [1.0, -2.0, 3.0]);
        assert_eq!(numbers("<1,2>"), [1.0, 2.0]);
        assert_eq!(numbers("rgb<1,0.5,0>"), [1.0, 0.5, 0.0, 0.0, 0.0]);
        assert_eq!(numbers("color rgbt <1,0.5,0,0.3>"), [1.0, 0.5, 0.0, 0.0, 0.3]);
        assert_eq!(numbers("color <1,0.5,0>"), [1.0, 0.5, 0.0, 0.0, 0.0]);
        assert_eq!(numbers("rgb 0.5"), [0.5, 0.5, 0.5, 0.0, 0.0]);
        assert!((numbers("srgb 0.5")[0] - 0.214).abs() < 1e-3);
        assert!(matches!(parse_value("\"<1,2>\""), Ok(Value::Text(text)) if &*text == "<1,2>"));
    }

    #[test]
    fn errors_describe_the_fault() {
        for (text, says) in [
            ("<1,2", "`>` is missing"),
            ("<1>", "2 to 5 numbers"),
            ("<1,2,3,4,5,6>", "2 to 5 numbers"),
            ("<1,b,3>", "`b` in `<1,b,3>` is no number"),
            ("<1,nan,3>", "`nan`"),
            ("rgb <1,2>", "3 numbers, not 2: rgb <1, 0.5, 0>"),
            ("rgb", "needs numbers"),
            ("color 3", "is no colour"),
            ("Red", "is no number, vector (<1, 2, 3>) or colour (rgb <1, 0, 0>)"),
            ("", "is no number"),
            ("\"", "is no number"),
            ("inf", "is no number"),
        ] {
            let error = parse_value(text).unwrap_err();
            assert!(error.contains(says), "{text}: {error}");
        }
    }
}
