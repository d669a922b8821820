//! `subsurface { … }` of `global_settings` (manual, "Subsurface Light Transport").

use crate::diagnostic::Result;
use crate::value::ValueKind::{Flag, Float};
use crate::value::ranges::in_range;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// Maximum number of samples of a point.
const MAX_SAMPLES: f64 = 1e9;

/// Settings of subsurface light transport: light that enters a solid and leaves it elsewhere.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SubsurfaceSettings {
    /// Number of points of a surface that send diffuse light to each visible point.
    pub diffuse_samples: u32,
    /// Number of points below the surface that scatter light once towards each visible point.
    pub single_samples: u32,
    /// True for `subsurface { radiosity on }`: light that radiosity gathers enters solids, too.
    pub radiosity: bool,
}

impl Default for SubsurfaceSettings {
    fn default() -> Self {
        Self { diffuse_samples: 50, single_samples: 50, radiosity: false }
    }
}

/// Words of the `subsurface` block of `global_settings`, and how each is read.
const ROWS: &[Row<SubsurfaceSettings>] = &[
    word(
        "samples",
        Float,
        "50, 50",
        "two numbers: samples of light that is scattered often, and of light scattered once",
    )
    .sets(SubsurfaceSettings::read_samples),
    word("radiosity", Flag, "off", "light that radiosity gathers enters solids, too")
        .sets(|s, r| set(&mut s.radiosity, r.flag())),
];

/// Specification of the block `subsurface { … }` of `global_settings`.
pub const SUBSURFACE: Spec = Spec {
    name: "subsurface",
    summary: "switches `finish { subsurface }` on: light that enters a solid and leaves it elsewhere",
    words: specs!(ROWS),
    ..Spec::EMPTY
};

impl SubsurfaceSettings {
    /// Reads a `subsurface` block from its opening to its closing brace.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood or out of range.
    pub fn read_with_braces(r: &mut dyn Reader) -> Result<Self> {
        let mut out = Self::default();
        r.take_token()?;
        loop {
            match r.peek_next()? {
                Next::End => return r.leave_block().map(|_| out),
                next if read_row(ROWS, &mut out, next, r)? => {}
                _ => return Err(r.unknown_word_in(&SUBSURFACE)),
            }
        }
    }

    fn read_samples(&mut self, r: &mut dyn Reader) -> Result<()> {
        let mut count = || in_range("samples", 0.0..=MAX_SAMPLES, r).map(|count| count as u32);
        self.diffuse_samples = count()?;
        self.single_samples = count()?;
        Ok(())
    }
}
