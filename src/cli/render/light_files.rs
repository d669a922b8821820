//! Files of photons and of radiosity samples that a render loads and saves.

use super::config::Config;
use super::monitor::ReceiveLight;
use crate::advice;
use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::render;
use crate::scene::{LightFileError, LightKind, LoadedLight, PreparedLight, SaveFile, is_light_file};
use crate::source::{Disk, Files, Sandbox, Sandboxed, Sources, Span, WriteMode, WritePolicy};
use crate::world::World;
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// Loads the radiosity samples of `--load-radiosity`, and sets the destination of `--save-radiosity`. The options have no
/// effect on a scene without radiosity. Returns warnings about the loaded file.
pub fn add_option_files(world: &mut World, config: &Config, sources: &Sources) -> Vec<Diagnostic> {
    let Some(radiosity) = &mut world.radiosity else { return vec![] };
    if let Some(path) = &config.save_radiosity {
        radiosity.saved.save = Some(SaveFile { kind: LightKind::Radiosity, path: path.clone(), source: Span::NONE });
    }
    let Some(path) = &config.load_radiosity else { return vec![] };
    let found = Some(path.as_path()).filter(|path| Disk.exists(path));
    let name = path.to_string_lossy();
    match LoadedLight::read(LightKind::Radiosity, &name, found, Span::NONE, sources.files()) {
        Ok(loaded) => {
            radiosity.saved.loaded = Some(loaded);
            advice::other_light_warning(world, LightKind::Radiosity).into_iter().collect()
        }
        Err(warning) => vec![*warning],
    }
}

/// Uses the photons and radiosity samples of a file that `durer prepare` wrote for this picture, in place of those that the
/// scene loads or computes.
///
/// # Errors
/// E0020 if the file was prepared for another picture; E0003 for an unreadable or damaged file.
pub fn add_prepared(world: &mut World, path: &Path, options: &render::Options) -> Result<()> {
    let name = path.to_string_lossy();
    let unreadable = |reason: &str| {
        let text = format!("`{name}` {reason}");
        let help = "`durer prepare` writes the file anew";
        Box::new(Diagnostic::new(codes::FILE_UNREADABLE, Span::NONE, text).help(help))
    };
    let bytes = Disk.read(path).map_err(|error| file::unreadable(&Disk, path, &error.into()))?;
    let PreparedLight { photons, radiosity } = PreparedLight::parse(&bytes).map_err(|error| match error {
        LightFileError::Foreign | LightFileError::PovRay => unreadable("was not written by `durer prepare`"),
        LightFileError::OtherKind => unreadable("was saved by a scene; its `load_file` reads the file"),
        LightFileError::OtherVersion => unreadable("was written by another version of durer"),
        LightFileError::Damaged => unreadable("is damaged or cut off"),
    })?;
    let digests = render::light_digests(world, options);
    let saved = [
        world.photon_map.as_mut().map(|settings| &mut settings.saved),
        world.radiosity.as_mut().map(|settings| &mut settings.saved),
    ];
    for ((saved, light), digest) in saved.into_iter().zip([photons, radiosity]).zip(digests) {
        match (saved, light) {
            (Some(saved), Some(file)) if file.header.computation == digest => {
                saved.loaded = Some(LoadedLight { file, name: name.to_string(), source: Span::NONE });
            }
            (_, None) => {}
            _ => {
                let text = format!("`{name}` was prepared for another picture");
                let help = "the scene, the size of the picture, the frame and the quality have to be the same; \
                            `durer prepare` writes the file anew";
                return Diagnostic::new(codes::OTHER_PREPARATION, Span::NONE, text).help(help).into();
            }
        }
    }
    Ok(())
}

/// Writes photons and radiosity samples to files.
pub struct LightSaver {
    /// Policy for files that a scene names.
    sandbox: Sandbox,
    warnings: Mutex<Vec<Diagnostic>>,
}

impl ReceiveLight for LightSaver {
    /// Saves light to its file. A file that cannot be written gives a warning, because the picture does not depend on the
    /// file.
    fn receive(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) {
        let saved = match file.source {
            Span::NONE => save_for_user(&file.path, file.kind, write),
            _ => self.save_for_scene(file, write),
        };
        self.warnings.lock().unwrap_or_else(PoisonError::into_inner).extend(saved.err().map(|warning| *warning));
    }
}

impl LightSaver {
    /// Creates a saver; `sandbox` is the policy for files that the scene names.
    pub fn new(sandbox: Sandbox) -> Self {
        Self { sandbox, warnings: Mutex::default() }
    }

    /// Returns the warnings about files that could not be written.
    pub fn warnings(&self) -> Vec<Diagnostic> {
        self.warnings.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Saves light to a file that the scene names, if its policy allows that.
    fn save_for_scene(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) -> Result<()> {
        if let WritePolicy::InMemory = self.sandbox.write {
            let error = io::Error::other("only `durer render` without `--untrusted` writes the files of a scene");
            return unsaved_warning(file.kind, &file.path, file.source, &error).into();
        }
        let files = Sandboxed::new(&Disk, &self.sandbox);
        let written = files.open_writer(&file.path, WriteMode::Truncate).and_then(|mut out| write(&mut out));
        written.map_err(|error| {
            // The policy has no number of the operating system.
            let is_forbidden = error.kind() == ErrorKind::PermissionDenied && error.raw_os_error().is_none();
            let help = "scenes create files below the current folder, and replace those that they created; \
                        --allow-write DIR allows more";
            unsaved_warning(file.kind, &file.path, file.source, &error)
                .maybe_help(is_forbidden.then(|| help.into()))
                .into()
        })
    }
}

/// Saves light to a file that the command line names. An existing file is replaced only if it contains saved light.
fn save_for_user(path: &Path, kind: LightKind, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) -> Result<()> {
    let save = || {
        if Disk.exists(path) && !is_light_file(&Disk.read(path)?) {
            return Err(io::Error::other("the file exists, and durer did not save it"));
        }
        let mut draft = Disk.draft(path)?;
        write(&mut draft)?;
        draft.commit(&Disk)
    };
    save().map_err(|error| unsaved_warning(kind, path, Span::NONE, &error).into())
}

fn unsaved_warning(kind: LightKind, path: &Path, source: Span, error: &io::Error) -> Diagnostic {
    let text = format!("the {} were not saved to `{}`: {}", kind.contents(), path.display(), file::reason(error));
    Diagnostic::new(codes::UNSAVED_LIGHT, source, text)
}
