//! `photons { … }` of a light source (manual, "Photons and Light Sources").

use crate::diagnostic::Result;
use crate::value::ValueKind::Flag;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// Emission of photons by a light source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct LightPhotons {
    /// False if targets refract no photons of the light; `None` for the object's choice.
    pub refraction: Option<bool>,
    /// False if targets reflect no photons of the light; `None` for the object's choice.
    pub reflection: Option<bool>,
    /// True if the lights of an area light's grid emit the photons; otherwise the centre does.
    pub area_light: bool,
}

/// Words of the `photons` block of a light source, and how each is read.
const LIGHT_PHOTON_ROWS: &[Row<LightPhotons>] = &[
    word("refraction", Flag, "of the object", "targets refract photons of the light")
        .sets(|s, r| set(&mut s.refraction, r.flag().map(Some))),
    word("reflection", Flag, "of the object", "targets reflect photons of the light")
        .sets(|s, r| set(&mut s.reflection, r.flag().map(Some))),
    word("area_light", Flag, "off", "all lights of the grid of an area light emit photons")
        .sets(|s, r| set(&mut s.area_light, r.flag())),
];

/// Specification of the block `photons { … }` of a light source.
pub const LIGHT_PHOTONS: Spec = Spec {
    name: "photons",
    summary: "emission of photons by a light source",
    words: specs!(LIGHT_PHOTON_ROWS),
    ..Spec::EMPTY
};

impl LightPhotons {
    /// Reads the `photons` block of a light source, from its opening to its closing brace; what the block states
    /// replaces the present values.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read_with_braces(&mut self, r: &mut dyn Reader) -> Result<()> {
        r.take_token()?;
        loop {
            match r.peek_next()? {
                Next::End => return r.leave_block().map(drop),
                next if read_row(LIGHT_PHOTON_ROWS, self, next, r)? => {}
                _ => return Err(r.unknown_word_in(&LIGHT_PHOTONS)),
            }
        }
    }
}
