//! Values of command-line options that have a syntax of their own.

use crate::render::Shard;
use crate::value::parse_value;
use std::path::PathBuf;
use std::str::FromStr;

/// Size of a picture: `640x480`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
}

impl Default for Size {
    fn default() -> Self {
        Self { width: 640, height: 480 }
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |side: &str| side.parse().ok().filter(|&n| n > 0);
        let (width, height) = text.split_once(['x', 'X', '×']).ok_or("expected width and height, such as 640x480")?;
        match (side(width), side(height)) {
            (Some(width), Some(height)) => Ok(Self { width, height }),
            _ => Err("both must be whole numbers of pixels, 1 or more".into()),
        }
    }
}

/// Value of `--shard`: a share of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShardChoice {
    /// The shard that the command line states: `3/16`.
    Exact(Shard),
    /// The shard of the scheduler's task: `auto`, or `auto/16` with the number of shards.
    Auto(Option<usize>),
}

impl FromStr for ShardChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.parse::<usize>().ok().filter(|n| (1..=MAX_SHARDS).contains(n));
        let choice = match text.split_once('/') {
            None if text == "auto" => Some(Self::Auto(None)),
            Some(("auto", count)) => number(count).map(|count| Self::Auto(Some(count))),
            Some((index, count)) => match (number(index), number(count)) {
                (Some(index), Some(count)) if index <= count => Some(Self::Exact(Shard { index, count })),
                _ => None,
            },
            None => None,
        };
        choice.ok_or_else(|| "expected a shard and the number of shards, such as 3/16, or `auto`".into())
    }
}

/// Largest number of shards of a picture.
const MAX_SHARDS: usize = 1_000_000;

/// Language version: `3.1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Version(pub f64);

impl FromStr for Version {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let version = text.parse().ok().filter(|version| (1.0..=100.0).contains(version));
        version.map(Self).ok_or("expected a number such as 3.1 or 3.7".into())
    }
}

/// Threshold of anti-aliasing, 0 or more: `0.3`, or `None` for `off`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Antialias(pub Option<f64>);

impl FromStr for Antialias {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse::<f64>() {
            _ if text.eq_ignore_ascii_case("off") => Ok(Self(None)),
            Ok(threshold) if threshold >= 0.0 => Ok(Self(Some(threshold))),
            _ => Err("expected a number from 0 (all pixels) to 3 (none), or `off`".into()),
        }
    }
}

/// A program and its arguments with the placeholders `{file}`, `{line}` and `{column}` for a position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Command(Vec<String>);

impl FromStr for Command {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match shlex::split(text) {
            Some(words) if !words.is_empty() => Ok(Self(words)),
            Some(_) => Err("expected a program, such as 'code -g {file}:{line}:{column}'".into()),
            None => Err("missing closing quote".into()),
        }
    }
}

impl Command {
    /// Returns the command for a position in a file. Without `{file}`, the file becomes the last argument.
    #[cfg(feature = "watch")]
    pub fn command_line_for_position(&self, file: &str, line: usize, column: usize) -> Vec<String> {
        let put = |word: &String| {
            let word = word.replace("{line}", &line.to_string()).replace("{column}", &column.to_string());
            word.replace("{file}", file)
        };
        let named = self.0.iter().any(|word| word.contains("{file}"));
        self.0.iter().map(put).chain((!named).then(|| file.to_string())).collect()
    }
}

/// Option value that is a number from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share(pub f64);

impl FromStr for Share {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let share = text.parse().ok().filter(|share| (0.0..=1.0).contains(share));
        share.map(Self).ok_or("expected a number from 0 to 1".into())
    }
}

/// Exponent of a transfer curve, from 0.1 to 10.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gamma(pub f64);

impl FromStr for Gamma {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let gamma = text.parse().ok().filter(|gamma| (0.1..=10.0).contains(gamma));
        gamma.map(Self).ok_or("expected a number from 0.1 to 10, such as 2.2".into())
    }
}

/// Transfer curve of a file: `srgb`, or the gamma of a power curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileGamma(pub crate::color::Gamma);

impl FromStr for FileGamma {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse::<Gamma>() {
            _ if text.eq_ignore_ascii_case("srgb") => Ok(Self(crate::color::Gamma::Srgb)),
            Ok(Gamma(gamma)) => Ok(Self(crate::color::Gamma::Power(gamma))),
            Err(_) => Err("expected `srgb`, or a number from 0.1 to 10, such as 2.2".into()),
        }
    }
}

/// Region of the picture, `X,Y,W,H`, in pixels from the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part(pub crate::render::Region);

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Vec<usize> = text.split(',').map_while(|n| n.trim().parse().ok()).collect();
        match numbers[..] {
            [x, y, width, height] if width > 0 && height > 0 && text.matches(',').count() == 3 => {
                Ok(Self(crate::render::Region { x, y, width, height }))
            }
            _ => Err("expected four whole numbers: left, top, width and height, such as 100,50,64,48".into()),
        }
    }
}

/// Position of a pixel, `X,Y`, counted from the top left, which may be outside of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Column of the pixel, from the left.
    pub x: i64,
    /// Row of the pixel, from the top.
    pub y: i64,
}

impl FromStr for Pixel {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse = || {
            let (x, y) = text.split_once(',')?;
            Some(Self { x: x.trim().parse().ok()?, y: y.trim().parse().ok()? })
        };
        parse().ok_or_else(|| "expected two whole numbers: column and row, such as 320,240".into())
    }
}

/// Frames of an animation: `A-B[:STEP]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frames {
    /// Number of the first frame.
    pub first: u32,
    /// Number of the last frame.
    pub last: u32,
    /// Difference between consecutive frames.
    pub step: u32,
    /// Number of digits of the last frame as it was typed; file names have as many.
    pub digits: usize,
}

impl FromStr for Frames {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse = || {
            let (range, step) = text.split_once(':').unwrap_or((text, "1"));
            let (first, last) = range.split_once('-')?;
            let frames = Self {
                first: first.parse().ok()?,
                last: last.parse().ok()?,
                step: step.parse().ok()?,
                digits: last.len().max(first.trim_start_matches('0').len()),
            };
            (frames.first <= frames.last && frames.step > 0).then_some(frames)
        };
        parse().ok_or_else(|| "expected first and last frame, such as 1-30, or 1-30:5 for every fifth".into())
    }
}

/// Value of `clock`: `X`, or `A..B` for the first and the last frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Value of `clock` in the first frame.
    pub first: f64,
    /// Value of `clock` in the last frame.
    pub last: f64,
}

impl FromStr for Clock {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.parse::<f64>().ok().filter(|x| x.is_finite());
        let (first, last) = text.split_once("..").unwrap_or((text, text));
        match (number(first), number(last)) {
            (Some(first), Some(last)) => Ok(Self { first, last }),
            _ => Err("expected a number such as 0.5, or two for an animation: 0..10".into()),
        }
    }
}

/// Declaration `NAME=VALUE`, where the value is a number, text in quotes, a vector or a colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declare {
    /// Declared identifier.
    pub name: String,
    /// Value as it was typed.
    pub value: String,
}

impl FromStr for Declare {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, value) = text.split_once('=').ok_or("expected a name and a value, such as Speed=2.5")?;
        let is_name = name.starts_with(|c: char| c.is_alphabetic() || c == '_')
            && name.chars().all(|c| c.is_alphanumeric() || c == '_');
        if !is_name {
            return Err(format!("`{name}` is not an identifier, which consists of letters, digits and `_`"));
        }
        match parse_value(value) {
            Ok(_) => Ok(Self { name: name.into(), value: value.into() }),
            Err(why) if value.starts_with(|c: char| c.is_alphabetic()) => {
                Err(format!("{why}; text needs quotes: '{name}=\"{value}\"'"))
            }
            Err(why) => Err(why),
        }
    }
}

/// Memory size in bytes: `500M`, `2G`. The letters are powers of 1024.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bytes(pub u64);

impl FromStr for Bytes {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim_end_matches(['b', 'B', 'i']);
        let (digits, shift) = match text.char_indices().last() {
            Some((i, 'k' | 'K')) => (&text[..i], 10),
            Some((i, 'm' | 'M')) => (&text[..i], 20),
            Some((i, 'g' | 'G')) => (&text[..i], 30),
            _ => (text, 0),
        };
        let bytes = digits.parse().ok().and_then(|n: u64| n.checked_mul(1 << shift));
        bytes.map(Self).ok_or_else(|| "expected a number of bytes, such as 500M or 2G".into())
    }
}

/// Duration in seconds, 0 or more.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds(pub f64);

impl FromStr for Seconds {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let seconds = text.trim_end_matches('s').parse().ok().filter(|s: &f64| *s >= 0.0 && *s < 1e12);
        seconds.map(Self).ok_or_else(|| "expected a number of seconds, such as 60".into())
    }
}

/// Destination of `--stats`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stats {
    /// JSON on standard output.
    Json,
    /// JSON in a file.
    File(PathBuf),
}

impl FromStr for Stats {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(if text == "json" { Self::Json } else { Self::File(text.into()) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_values_are_read() {
        assert_eq!("4x3".parse(), Ok(Size { width: 4, height: 3 }));
        assert_eq!("off".parse(), Ok(Antialias(None)));
        assert_eq!("0.1".parse(), Ok(Antialias(Some(0.1))));
        assert_eq!("3-12:2".parse(), Ok(Frames { first: 3, last: 12, step: 2, digits: 2 }));
        assert_eq!("05-007".parse(), Ok(Frames { first: 5, last: 7, step: 1, digits: 3 }));
        assert_eq!("-1.5".parse(), Ok(Clock { first: -1.5, last: -1.5 }));
        assert_eq!("0..10".parse(), Ok(Clock { first: 0.0, last: 10.0 }));
        assert_eq!("-3,7".parse(), Ok(Pixel { x: -3, y: 7 }));
        assert_eq!("2G".parse(), Ok(Bytes(2 << 30)));
        assert_eq!("10MiB".parse(), Ok(Bytes(10 << 20)));
        assert_eq!("A=1e3".parse(), Ok(Declare { name: "A".into(), value: "1e3".into() }));
        assert_eq!("A=\"x y\"".parse(), Ok(Declare { name: "A".into(), value: "\"x y\"".into() }));
    }

    #[test]
    fn invalid_values_are_refused() {
        for text in ["", "640", "0x5", "-1x5", "axb", "5x", "99999999999999999999x1"] {
            assert!(text.parse::<Size>().is_err(), "{text}");
        }
        for text in ["1,2,3", "1,2,0,4", "1,2,3,4,5", "a,2,3,4", "1,2,3,4,"] {
            assert!(text.parse::<Part>().is_err(), "{text}");
        }
        for text in ["5", "5-3", "1-3:0", "a-b", "1-"] {
            assert!(text.parse::<Frames>().is_err(), "{text}");
        }
        assert!("on".parse::<Antialias>().is_err() && "-1".parse::<Antialias>().is_err());
        assert!("nan".parse::<Antialias>().is_err() && "nan".parse::<Clock>().is_err());
        for (text, says) in [("A=x", "'A=\"x\"'"), ("P=<1,2", "`>` is missing"), ("C=rgb <1>", "2 to 5 numbers")] {
            assert!(text.parse::<Declare>().unwrap_err().contains(says), "{text}");
        }
        assert!("A=x".parse::<Declare>().is_err() && "1=2".parse::<Declare>().is_err());
        assert!("99999999999G".parse::<Bytes>().is_err());
    }
}
