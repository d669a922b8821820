//! Options of durer that POV-Ray splits into several options, which are combined after all words are read.

use super::number;
use crate::cli::animation::Animation;
use crate::cli::args::values::{Clock, FileGamma, Size};
use crate::image_io::Format;
use std::path::{Path, PathBuf};

/// Values of POV-Ray's options that were read so far.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    pub input: Option<String>,
    pub output: Option<String>,
    pub format: Option<&'static str>,
    /// True if the output is a compressed TGA file.
    pub is_compressed_tga: bool,
    /// Folder in the scene's name on the command line or in the INI file; empty for the current folder.
    pub scene_folder: PathBuf,
    /// True for POV-Ray's own command line, where output names, alpha and regions follow POV-Ray's rules.
    pub is_povray_line: bool,
    pub depth: Option<u8>,
    /// True for grayscale, which always has 16 bits (manual, "HF_Gray_16").
    pub gray: bool,
    /// True to write an alpha channel, where the format can hold one.
    pub alpha: bool,
    pub width: Option<usize>,
    pub height: Option<usize>,
    pub start_column: Option<f64>,
    pub end_column: Option<f64>,
    pub start_row: Option<f64>,
    pub end_row: Option<f64>,
    pub clock: Option<f64>,
    pub initial_frame: Option<u32>,
    pub final_frame: Option<u32>,
    pub initial_clock: f64,
    pub final_clock: f64,
    pub subset_start: Option<f64>,
    pub subset_end: Option<f64>,
    pub frame_step: u32,
    pub cyclic: bool,
    pub antialias: Option<bool>,
    pub threshold: f64,
    pub sampling_method: Option<&'static str>,
    pub sampling_depth: Option<u32>,
    pub jitters: Option<bool>,
    pub jitter: f64,
    pub antialias_gamma: Option<f64>,
    pub file_gamma: Option<String>,
    pub dithers: bool,
    pub dither_method: Option<&'static str>,
    /// Path of the INI file to write (`Create_Ini`).
    pub created_ini: Option<String>,
    /// True to append to text files (`Append_File`).
    pub appends_text: bool,
    /// Path of the file of radiosity samples (`Radiosity_File_Name`); `None` for `object.rca`.
    pub radiosity_file: Option<String>,
    pub loads_radiosity: bool,
    pub saves_radiosity: bool,
}

/// Name of the file of radiosity samples without `Radiosity_File_Name`.
const RADIOSITY_FILE: &str = "object.rca";

type Checked = Result<(), String>;

impl Settings {
    /// Creates settings with POV-Ray's defaults.
    pub fn new() -> Self {
        Self { final_clock: 1.0, frame_step: 1, threshold: 0.3, jitter: 1.0, ..Self::default() }
    }

    pub fn change(&mut self, put: impl FnOnce(&mut Self)) -> Checked {
        put(self);
        Ok(())
    }

    pub fn set_number(&mut self, text: &str, put: impl FnOnce(&mut Self, f64)) -> Checked {
        let x = number::parse_number_prefix(text).filter(|x| x.is_finite()).ok_or("expected a number")?;
        self.change(|p| put(p, x))
    }

    /// Sets a frame number: fractions are cut off, and negative numbers become 0, as in POV-Ray.
    pub fn set_frame_number(&mut self, text: &str, put: impl FnOnce(&mut Self, u32)) -> Checked {
        let n = number::parse_whole_prefix(text).ok_or("expected a whole number")?;
        self.change(|p| put(p, n as u32))
    }

    pub fn set_pixel_count(&mut self, text: &str, put: impl FnOnce(&mut Self, usize)) -> Checked {
        let n = number::parse_whole_prefix(text)
            .filter(|&n| n >= 1.0)
            .ok_or("expected a whole number of pixels, 1 or more")?;
        self.change(|p| put(p, n as usize))
    }

    pub fn set_clock(&mut self, text: &str) -> Checked {
        self.set_number(text, |p, x| p.clock = Some(x))
    }

    pub fn set_antialias(&mut self, threshold: &str, on: bool) -> Checked {
        self.antialias = Some(on);
        if threshold.is_empty() { Ok(()) } else { self.set_number(threshold, |p, x| p.threshold = x) }
    }

    /// Sets the method of anti-aliasing, 1 or 2.
    pub fn set_sampling_method(&mut self, text: &str) -> Checked {
        let method = match number::parse_whole_prefix(text) {
            Some(1.0) => "grid",
            Some(2.0) => "corners",
            _ => return Err("the methods are 1 and 2".into()),
        };
        self.change(|p| p.sampling_method = Some(method))
    }

    pub fn set_sampling_depth(&mut self, text: &str) -> Checked {
        let depth = number::parse_whole_prefix(text).ok_or("expected a number")?;
        self.change(|p| p.sampling_depth = Some(depth.clamp(1.0, 9.0) as u32))
    }

    /// Sets the jitter of anti-aliasing; 0 and negative numbers turn it off (manual).
    pub fn set_jitter(&mut self, text: &str, on: bool) -> Checked {
        self.jitters = Some(on);
        if text.is_empty() { Ok(()) } else { self.set_number(text, |p, x| p.jitter = x.clamp(0.0, 1.0)) }
    }

    pub fn set_antialias_gamma(&mut self, text: &str) -> Checked {
        let gamma = number::parse_number_prefix(text)
            .filter(|x| (0.1..=10.0).contains(x))
            .ok_or("expected a number from 0.1 to 10")?;
        self.change(|p| p.antialias_gamma = Some(gamma))
    }

    /// Sets the type of the picture file: a letter, and optional bits per channel or `g` for grayscale, such as `N16` or `Ng`.
    pub fn set_file_type(&mut self, text: &str) -> Checked {
        let mut letters = text.chars();
        let letter = letters.next().map(|c| c.to_ascii_uppercase());
        self.is_compressed_tga = letter == Some('C');
        self.format = match letter {
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
        } else if rest.eq_ignore_ascii_case("g") {
            // Types without grayscale are refused later, with the format's own message.
            self.change(|p| p.gray = true)
        } else if has_depth {
            self.set_bits_per_channel(rest)
        } else {
            rest.parse::<u8>().map(|_| ()).map_err(|_| "expected a number of bits".into())
        }
    }

    /// Sets the bits per channel: 1 to 16, rounded up to 8 or 16.
    pub fn set_bits_per_channel(&mut self, text: &str) -> Checked {
        let bits = number::parse_whole_prefix(text)
            .filter(|bits| (1.0..=16.0).contains(bits))
            .ok_or("bits go from 5 to 16")?;
        self.change(|p| p.depth = Some(if bits > 8.0 { 16 } else { 8 }))
    }

    pub fn set_file_gamma(&mut self, text: &str) -> Checked {
        text.parse::<FileGamma>()?;
        self.change(|p| p.file_gamma = Some(text.to_lowercase()))
    }

    /// Turns dithering on or off, and sets the method if one is named.
    pub fn set_dither(&mut self, text: &str, on: bool) -> Checked {
        self.dithers = on;
        if text.is_empty() { Ok(()) } else { self.set_dither_method(text) }
    }

    pub fn set_dither_method(&mut self, text: &str) -> Checked {
        let known = ["b2", "b3", "b4", "d1", "d2", "fs"];
        let method = known.into_iter().find(|known| known.eq_ignore_ascii_case(text));
        let method = method.ok_or("the methods are B2, B3, B4, D1, D2 and FS")?;
        self.change(|p| p.dither_method = Some(method))
    }

    /// Returns the settings as options of durer. With `antialias_off_by_default`, anti-aliasing is off unless it was turned on.
    pub fn durer_options(&self, antialias_off_by_default: bool) -> Vec<String> {
        let mut out = Vec::new();
        let mut put = |name: &str, value: String| out.push(format!("{name}={value}"));
        match self.antialias {
            Some(true) => put("--aa", self.threshold.to_string()),
            None if !antialias_off_by_default => {}
            _ => put("--aa", "off".into()),
        }
        let theirs = (self.antialias == Some(true)).then_some("grid");
        self.sampling_method.or(theirs).iter().for_each(|method| put("--aa-method", method.to_string()));
        self.sampling_depth.iter().for_each(|depth| put("--aa-depth", depth.to_string()));
        self.jitters.iter().for_each(|on| put("--aa-jitter", if *on { self.jitter } else { 0.0 }.to_string()));
        self.antialias_gamma.iter().for_each(|gamma| put("--aa-gamma", gamma.to_string()));
        self.file_gamma.iter().for_each(|gamma| put("--file-gamma", gamma.clone()));
        if self.dithers {
            put("--dither", self.dither_method.unwrap_or("fs").into());
        }
        let size = Size::default();
        let (width, height) = (self.width.unwrap_or(size.width), self.height.unwrap_or(size.height));
        if self.width.or(self.height).is_some() {
            put("--size", format!("{width}x{height}"));
        }
        let sides = [self.start_column, self.end_column, self.start_row, self.end_row];
        if sides.iter().any(Option::is_some) {
            let (x, w) = region_start_and_length(self.start_column, self.end_column, width);
            let (y, h) = region_start_and_length(self.start_row, self.end_row, height);
            put("--region", format!("{x},{y},{w},{h}"));
            if self.is_povray_line {
                put("--outside", "black".into());
            }
        }
        let packing = self.is_compressed_tga.then(|| "rle".to_string());
        let output = if self.is_povray_line { self.output_name_as_povray() } else { self.output_name() };
        let is_unnamed = output.as_deref().is_some_and(|name| is_special(Path::new(name)));
        let format = self.format.or(is_unnamed.then_some("png")).map(Into::into);
        for (name, value) in [("--output", output), ("--format", format), ("--packing", packing)] {
            value.into_iter().for_each(|value| put(name, value));
        }
        let radiosity = || self.radiosity_file.clone().unwrap_or(RADIOSITY_FILE.into());
        let uses = [("--load-radiosity", self.loads_radiosity), ("--save-radiosity", self.saves_radiosity)];
        uses.iter().filter(|(_, is_on)| *is_on).for_each(|(name, _)| put(name, radiosity()));
        self.depth.iter().filter(|_| !self.gray).for_each(|depth| put("--bit-depth", depth.to_string()));
        if let (Some(clock), None) = (self.clock, self.animation()) {
            put("--clock", clock.to_string());
        }
        if self.gray {
            out.push("--gray".into());
        }
        // (`+UA` has no effect on formats without alpha.)
        let format = Format::from_name(self.format.unwrap_or("png")).filter(|_| self.is_povray_line);
        if self.alpha && format.is_none_or(Format::has_alpha) {
            out.push("--alpha".into());
        }
        out
    }

    /// Returns the folder of the picture on POV-Ray's own command line; an empty path for the current folder.
    pub fn output_folder(&self) -> PathBuf {
        let name = self.output_name_as_povray().filter(|name| name != "-").map(PathBuf::from).unwrap_or_default();
        let is_folder = name.as_os_str().to_string_lossy().ends_with(std::path::is_separator) || name.is_dir();
        if is_folder { name } else { name.parent().map(Path::to_path_buf).unwrap_or_default() }
    }

    /// Returns the output file on POV-Ray's own command line: beside the scene without `+O`, and always with the extension of
    /// the format, except for devices, folders and `-` for standard output. `None` for the default name in the current folder.
    fn output_name_as_povray(&self) -> Option<String> {
        let ending = self.format.unwrap_or("png");
        let Some(name) = self.output.as_ref().filter(|name| !name.is_empty()) else {
            let stem = Path::new(self.input.as_ref()?).file_stem()?;
            let beside = self.scene_folder.join(stem).display().to_string();
            return (!self.scene_folder.as_os_str().is_empty()).then(|| format!("{beside}.{ending}"));
        };
        let path = Path::new(name);
        if STANDARD_OUTPUT.contains(&name.as_str()) {
            return Some("-".into());
        }
        let is_whole = name == "-" || name.ends_with(std::path::is_separator) || is_special(path);
        if is_whole || path.extension().is_some_and(|found| found == ending) {
            return Some(name.clone());
        }
        Some(format!("{}.{ending}", name.trim_end_matches('.')))
    }

    /// Returns the output file; `None` without `+O`. An extension that is no picture format is a part of the name, as in
    /// POV-Ray.
    fn output_name(&self) -> Option<String> {
        let name = self.output.clone().filter(|name| !name.is_empty())?;
        let path = Path::new(&name);
        let is_whole = name == "-" || name.ends_with(std::path::is_separator) || path.exists() && !path.is_file();
        if is_whole || self.has_format_extension(path) {
            return Some(name);
        }
        Some(format!("{}.{}", name.trim_end_matches('.'), self.format.unwrap_or("png")))
    }

    /// True if the path has the extension of the chosen format, or of any format if none was chosen.
    fn has_format_extension(&self, path: &Path) -> bool {
        let found = Format::from_path(path).ok();
        found.is_some() && self.format.is_none_or(|format| Format::from_name(format) == found)
    }

    /// Returns the animation that the options describe; `None` for a single picture.
    pub fn animation(&self) -> Option<Animation> {
        // quirk: animation_of_one_frame
        let (first, last) = match (self.initial_frame, self.final_frame) {
            (None | Some(0), None | Some(0)) | (Some(1), Some(1)) => return None,
            (first, last) => (first.unwrap_or(1), last.unwrap_or(0)),
        };
        let end = last.max(first);
        // A cyclic animation has one frame more, which equals the first one and is not rendered.
        let last = end.saturating_add(u32::from(self.cyclic));
        let count = f64::from(last) - f64::from(first) + 1.0;
        let frame_of = |x: f64| if x < 1.0 { (x * count) as u32 } else { x as u32 };
        let start = self.subset_start.map_or(first, frame_of).max(first);
        Some(Animation {
            first,
            last,
            clock: Clock { first: self.initial_clock, last: self.final_clock },
            start,
            end: self.subset_end.map_or(end, frame_of).max(start),
            step: self.frame_step.max(1),
            digits: last.to_string().len(),
        })
    }
}

/// Names of standard output as a file.
const STANDARD_OUTPUT: &[&str] = &["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// True for a device or a pipe.
fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// Returns the first pixel and the number of pixels along one side of the region (quirk: `region_bounds`).
fn region_start_and_length(start: Option<f64>, end: Option<f64>, side: usize) -> (usize, usize) {
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
