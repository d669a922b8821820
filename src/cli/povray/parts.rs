//! Options of ours that POV-Ray spreads over several: put together when all are read.

use crate::cli::values::Size;

/// What was said so far.
#[derive(Clone, Debug, Default)]
pub struct Parts {
    pub input: Option<String>,
    pub output: Option<String>,
    pub format: Option<&'static str>,
    pub depth: Option<u8>,
    pub width: Option<usize>,
    pub height: Option<usize>,
    pub start_column: Option<f64>,
    pub end_column: Option<f64>,
    pub start_row: Option<f64>,
    pub end_row: Option<f64>,
    pub clock: Option<f64>,
    pub initial_frame: u32,
    pub final_frame: Option<u32>,
    pub initial_clock: f64,
    pub final_clock: f64,
    pub subset_start: Option<f64>,
    pub subset_end: Option<f64>,
    pub frame_step: u32,
    pub cyclic: bool,
    pub antialias: bool,
    pub threshold: f64,
}

type Checked = Result<(), String>;

impl Parts {
    /// POV-Ray's defaults where they differ from nothing.
    pub fn new() -> Self {
        Self { initial_frame: 1, final_clock: 1.0, frame_step: 1, threshold: 0.3, ..Self::default() }
    }

    pub fn set(&mut self, put: impl FnOnce(&mut Self)) -> Checked {
        put(self);
        Ok(())
    }

    pub fn number(&mut self, text: &str, put: impl FnOnce(&mut Self, f64)) -> Checked {
        let x = text.parse().ok().filter(|x: &f64| x.is_finite()).ok_or("a number is needed")?;
        self.set(|p| put(p, x))
    }

    pub fn whole(&mut self, text: &str, put: impl FnOnce(&mut Self, u32)) -> Checked {
        let n = text.parse().map_err(|_| "a whole number is needed")?;
        self.set(|p| put(p, n))
    }

    pub fn pixels(&mut self, text: &str, put: impl FnOnce(&mut Self, usize)) -> Checked {
        let n = text.parse().ok().filter(|&n| n > 0).ok_or("a whole number of pixels is needed, 1 or more")?;
        self.set(|p| put(p, n))
    }

    pub fn clock(&mut self, text: &str) -> Checked {
        self.number(text, |p, x| p.clock = Some(x))
    }

    pub fn antialias(&mut self, text: &str, on: bool) -> Checked {
        self.antialias = on;
        if text.is_empty() { Ok(()) } else { self.number(text, |p, x| p.threshold = x) }
    }

    /// A letter and maybe bits a channel: `N16`.
    pub fn file_type(&mut self, text: &str) -> Checked {
        let mut letters = text.chars();
        self.format = match letters.next().map(|c| c.to_ascii_uppercase()) {
            None => return Ok(()),
            Some('B' | 'S') => Some("bmp"),
            Some('C' | 'T') => Some("tga"),
            Some('E') => Some("exr"),
            Some('H') => Some("hdr"),
            Some('J') => Some("jpg"),
            Some('N') => Some("png"),
            Some('P') => Some("ppm"),
            Some(_) => return Err("the types are B, C, E, H, J, N, P, S and T".into()),
        };
        let rest = letters.as_str();
        let has_depth = matches!(self.format, Some("png" | "ppm"));
        if rest.is_empty() {
            Ok(())
        } else if has_depth {
            self.depth(rest)
        } else {
            rest.parse::<u8>().map(|_| ()).map_err(|_| "a number of bits is needed".into())
        }
    }

    /// 5 to 16 bits a channel, of which we have 8 and 16: whichever holds them.
    pub fn depth(&mut self, text: &str) -> Checked {
        let bits = text.parse::<u8>().ok().filter(|bits| (1..=16).contains(bits)).ok_or("bits go from 5 to 16")?;
        self.set(|p| p.depth = Some(if bits > 8 { 16 } else { 8 }))
    }

    pub fn file_gamma(&mut self, text: &str) -> Checked {
        if text.eq_ignore_ascii_case("srgb") {
            Ok(())
        } else {
            Err("files follow the sRGB curve; no other gamma is possible".into())
        }
    }

    /// Our options.
    pub fn options(&self, any_switch: bool) -> Vec<String> {
        let mut out = Vec::new();
        let mut put = |name: &str, value: String| out.push(format!("{name}={value}"));
        if self.antialias {
            put("--aa", self.threshold.to_string());
        } else if any_switch {
            put("--aa", "off".into());
        }
        let size = Size::default();
        let (width, height) = (self.width.unwrap_or(size.width), self.height.unwrap_or(size.height));
        if self.width.or(self.height).is_some() {
            put("--size", format!("{width}x{height}"));
        }
        let sides = [self.start_column, self.end_column, self.start_row, self.end_row];
        if sides.iter().any(Option::is_some) {
            let (x, w) = extent(self.start_column, self.end_column, width);
            let (y, h) = extent(self.start_row, self.end_row, height);
            put("--region", format!("{x},{y},{w},{h}"));
        }
        for (name, value) in [("--output", self.output.clone()), ("--format", self.format.map(Into::into))] {
            value.into_iter().for_each(|value| put(name, value));
        }
        self.depth.iter().for_each(|depth| put("--bit-depth", depth.to_string()));
        self.animation(&mut put);
        out
    }

    /// Frames and clock; the clock runs over the whole animation of which a subset is drawn.
    fn animation(&self, put: &mut impl FnMut(&str, String)) {
        let Some(last) = self.final_frame else {
            return self.clock.iter().for_each(|x| put("--clock", x.to_string()));
        };
        let (first, count) = (self.initial_frame, f64::from(last) - f64::from(self.initial_frame) + 1.0);
        let frame_of =
            |x: f64| if x <= 1.0 && x.fract() != 0.0 { (f64::from(first) + x * count - 1.0).round() } else { x };
        let start = self.subset_start.map_or(f64::from(first), frame_of).max(f64::from(first));
        let end = self.subset_end.map_or(f64::from(last), frame_of).min(f64::from(last));
        let steps = if self.cyclic { count } else { (count - 1.0).max(1.0) };
        let clock_of = |frame: f64| {
            self.initial_clock + (self.final_clock - self.initial_clock) * (frame - f64::from(first)) / steps
        };
        let digits = last.to_string().len();
        put("--frames", format!("{start}-{end:0>digits$}:{}", self.frame_step));
        put("--clock", format!("{}..{}", clock_of(start), clock_of(end)));
    }
}

/// First pixel and length along one side. Numbers above 1 count pixels from 1, up to 1 they are fractions; measured on
/// POV-Ray 3.7, where a start of 1 is the first pixel.
fn extent(start: Option<f64>, end: Option<f64>, side: usize) -> (usize, usize) {
    let from = match start {
        Some(x) if x > 1.0 => x - 1.0,
        Some(x) if x < 1.0 => (x.max(0.0) * side as f64).floor(),
        _ => 0.0,
    };
    let to = match end {
        Some(x) if x > 1.0 => x,
        Some(x) => (x.max(0.0) * side as f64).floor(),
        None => side as f64,
    };
    (from as usize, (to - from).max(0.0) as usize)
}
