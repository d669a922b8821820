//! The words `load_file` and `save_file` of `photons { }` and `radiosity { }` in `global_settings`.

use super::light_file::{LightFile, LightFileError, LightKind, MAX_LENGTH};
use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::source::{Files, Span};
use crate::value::Reader;
use std::path::{Path, PathBuf};

/// Settings of photons or radiosity samples that are loaded or saved: the file to load from, what was loaded, and the file to
/// save to, as stated in a block of `global_settings` or by an option.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SavedLight {
    /// Photons or radiosity samples that were loaded from a file, and are used in place of computed ones; `None` if
    /// they are computed.
    pub loaded: Option<LoadedLight>,
    /// File that the computed photons or radiosity samples are saved to; `None` if they are not saved.
    pub save: Option<SaveFile>,
}

/// Photons or radiosity samples that were loaded from a file, with the file's name.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedLight {
    /// Photons or radiosity samples of the loaded file.
    pub file: LightFile,
    /// Name of the file in the scene or on the command line, or path of the render journal that stored the light.
    pub name: String,
    /// Span of the file's name in the scene; [`Span::NONE`] if the scene does not name the file.
    pub source: Span,
}

/// File that computed photons or radiosity samples are to be saved to.
#[derive(Clone, Debug, PartialEq)]
pub struct SaveFile {
    /// Kind of the records to save: photons or radiosity samples.
    pub kind: LightKind,
    /// Path of the file that the photons or radiosity samples are saved to.
    pub path: PathBuf,
    /// Span of the file's name in the scene; [`Span::NONE`] if the scene does not name the file.
    pub source: Span,
}

impl SavedLight {
    /// Reads the file name after `load_file`, and loads the photons or radiosity samples of that file.
    pub(super) fn read_load_file(&mut self, kind: LightKind, r: &mut dyn Reader) -> Result<()> {
        let (at, name) = (r.span(), r.text()?);
        self.load(kind, &name, at, r)
    }

    /// Reads the name after `save_file`.
    pub(super) fn read_save_file(&mut self, kind: LightKind, r: &mut dyn Reader) -> Result<()> {
        let (source, name) = (r.span(), r.text()?);
        self.save = Some(SaveFile { kind, path: name.into(), source });
        Ok(())
    }

    /// Reads a file of saved photons or radiosity samples. A file that cannot be used is reported, and the photons or
    /// samples are computed as without the file.
    ///
    /// # Errors
    /// E0235 if the scene may not read the file.
    fn load(&mut self, kind: LightKind, name: &str, at: Span, r: &mut dyn Reader) -> Result<()> {
        self.loaded = None;
        let path = r.find_file(name, at)?;
        match LoadedLight::read(kind, name, path.as_deref(), at, r.files()) {
            Ok(loaded) => self.loaded = Some(loaded),
            Err(warning) => r.report(*warning),
        }
        Ok(())
    }
}

impl LoadedLight {
    /// Reads the file `name`, which was found at `path`, or not at all.
    ///
    /// # Errors
    /// The warning that the file is not used, with the reason.
    pub fn read(kind: LightKind, name: &str, path: Option<&Path>, source: Span, files: &dyn Files) -> Result<Self> {
        let file = match path {
            None => Err("was not found".into()),
            Some(path) if files.metadata(path).is_ok_and(|file| file.length > MAX_LENGTH) => {
                Err(format!("is larger than {} GB", MAX_LENGTH >> 30))
            }
            Some(path) => match files.read(path) {
                Ok(bytes) => LightFile::parse(bytes, kind).map_err(|error| rejection_reason(error, kind)),
                Err(error) => Err(format!("can't be read: {}", file::reason(&error))),
            },
        };
        match file {
            Ok(file) => Ok(Self { file, name: name.into(), source }),
            Err(reason) => {
                let text = format!("`{name}` {reason}: the {} are computed", kind.plural_name());
                let help = match kind {
                    LightKind::Photons => "`save_file` in place of `load_file` writes the file",
                    LightKind::Radiosity => "`save_file`, or `--save-radiosity` on the command line, writes the file",
                };
                Diagnostic::new(codes::UNUSED_LIGHT_FILE, source, text).help(help).into()
            }
        }
    }
}

/// Returns the reason for which a file is not used, as the rest of a sentence about the file.
fn rejection_reason(error: LightFileError, kind: LightKind) -> String {
    match error {
        LightFileError::WrittenByPovRay => {
            format!("was saved by POV-Ray, and durer reads only {} that it saved", kind.plural_name())
        }
        LightFileError::NotWrittenByDurer => format!("does not contain {}", kind.plural_name()),
        LightFileError::OtherKind => format!("contains {}, not {}", kind.other().plural_name(), kind.plural_name()),
        LightFileError::OtherVersion => "was saved by another version of durer".into(),
        LightFileError::Damaged => "is damaged or cut off".into(),
    }
}
