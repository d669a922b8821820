//! `photons { … }` of an object (manual, "Shooting Photons at an Object").

use crate::diagnostic::Result;
use crate::light::LightPhotons;
use crate::value::ValueKind::{Flag, Float};
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// Interaction of an object with photons.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PhotonSettings {
    /// Factor of the distance between the photons that lights shoot at the object; `None` if the object is no target.
    pub target: Option<f64>,
    /// True if the object refracts photons, false if not; `None` for the light's choice.
    pub refraction: Option<bool>,
    /// True if the object reflects photons, false if not; `None` for the light's choice.
    pub reflection: Option<bool>,
    /// True if photons pass the object on their way to a target, in a straight line; `None` for the group's choice.
    pub pass_through: Option<bool>,
    /// True if the object neither stores nor shows photons (`collect off`).
    pub ignores_photons: bool,
}

/// Words of the `photons` block, and how each is read.
const PHOTON_ROWS: &[Row<PhotonSettings>] = &[
    word("target", Float, "1", "lights shoot photons at the object; a smaller number makes them denser")
        .sets(|s, r| set(&mut s.target, r.optional_float().map(|spacing| Some(spacing.unwrap_or(1.0))))),
    word("refraction", Flag, "of the light", "the object refracts photons")
        .sets(|s, r| set(&mut s.refraction, r.flag().map(Some))),
    word("reflection", Flag, "of the light", "the object reflects photons")
        .sets(|s, r| set(&mut s.reflection, r.flag().map(Some))),
    word("collect", Flag, "on", "the object stores photons and shows their light")
        .sets(|s, r| set(&mut s.ignores_photons, r.flag().map(|collects| !collects))),
    word("pass_through", Flag, "off", "photons pass the object in a straight line on their way to a target")
        .sets(|s, r| set(&mut s.pass_through, r.flag().map(Some))),
];

/// Specification of the block `photons { … }` of an object.
pub const PHOTONS: Spec = Spec {
    name: "photons",
    summary: "interaction of an object with photons",
    words: specs!(PHOTON_ROWS),
    ..Spec::EMPTY
};

impl PhotonSettings {
    /// Returns whether the object refracts and whether it reflects photons of a light.
    pub fn refracts_and_reflects(&self, light: &LightPhotons) -> [bool; 2] {
        let agree = |object: Option<bool>, light: Option<bool>| match (object, light) {
            (Some(object), light) => object && light.unwrap_or(true),
            (None, light) => light.unwrap_or(false),
        };
        [agree(self.refraction, light.refraction), agree(self.reflection, light.reflection)]
    }

    /// Reads a `photons` block from its opening to its closing brace; what it states replaces the present values.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read_with_braces(&mut self, r: &mut dyn Reader) -> Result<()> {
        r.take_token()?;
        loop {
            match r.peek_next()? {
                Next::End => return r.leave_block().map(drop),
                next if read_row(PHOTON_ROWS, self, next, r)? => {}
                _ => return Err(r.unknown_word_in(&PHOTONS)),
            }
        }
    }

    /// Returns the settings of a part of a group with the settings `group`. The part's own values have priority.
    #[must_use]
    pub fn inherit(self, group: Self) -> Self {
        Self {
            target: self.target.or(group.target),
            refraction: self.refraction.or(group.refraction),
            reflection: self.reflection.or(group.reflection),
            pass_through: self.pass_through.or(group.pass_through),
            ignores_photons: self.ignores_photons || group.ignores_photons,
        }
    }
}
