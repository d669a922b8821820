//! `interior`: what fills a shape (manual, "Interior").

use super::words::INTERIOR;
use crate::diagnostic::Result;
use crate::value::{Next, Reader, ReaderExt, Said};
use serde::Serialize;

/// What light meets inside.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interior {
    /// Index of refraction.
    pub ior: f64,
    /// What was said and is not drawn yet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub undrawn: Vec<Said>,
}

impl Default for Interior {
    fn default() -> Self {
        Self { ior: 1.0, undrawn: vec![] }
    }
}

impl Interior {
    /// Reads what stands between the braces.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut out = Self::default();
        loop {
            match r.next()? {
                Next::End => return Ok(out),
                Next::Thing(_) => match r.thing::<Interior>()? {
                    Some(declared) => out = (*declared).clone(),
                    None => return Err(r.unknown_word("interior", &INTERIOR.names()).into()),
                },
                Next::Word("ior") => {
                    r.take()?;
                    out.ior = r.float()?;
                }
                Next::Word(word) | Next::Block(word) if INTERIOR.leaves_out(word) => {
                    out.undrawn.push(r.keep_undrawn(word)?);
                }
                _ => return Err(r.unknown_word("interior", &INTERIOR.names()).into()),
            }
        }
    }
}
