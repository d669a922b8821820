//! Files of photons and of radiosity samples that a render loads and saves; photons and radiosity samples in its journal.

use super::config::Config;
use super::monitor::ReceiveLight;
use crate::advice;
use crate::cli::journal::Journal;
use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::render;
use crate::scene::{
    Digest, LightFile, LightFileError, LightKind, LoadedLight, PreparedLight, SaveFile, SavedLight,
    is_light_file_or_empty,
};
use crate::source::{Disk, Files, Sandbox, Sandboxed, Sources, Span, WriteMode, WritePolicy};
use crate::world::World;
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Loads the radiosity samples of `--load-radiosity`, and sets the destination of `--save-radiosity`. The options have no
/// effect on a scene without radiosity. Returns warnings about the loaded file.
pub fn apply_radiosity_file_options(world: &mut World, config: &Config, sources: &Sources) -> Vec<Diagnostic> {
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
            advice::foreign_saved_light_warning(world, LightKind::Radiosity).into_iter().collect()
        }
        Err(warning) => vec![*warning],
    }
}

/// Uses the photons and radiosity samples of a file that `durer prepare` wrote for this picture, in place of those that the
/// scene loads or computes.
///
/// # Errors
/// E0020 if the file was prepared for another picture; E0003 for an unreadable or damaged file.
pub fn use_prepared_light(world: &mut World, path: &Path, options: &render::Options) -> Result<()> {
    let name = path.to_string_lossy();
    let unreadable = |reason: &str| {
        let text = format!("`{name}` {reason}");
        let help = "`durer prepare` writes the file anew";
        Box::new(Diagnostic::new(codes::FILE_UNREADABLE, Span::NONE, text).help(help))
    };
    let bytes = Disk.read(path).map_err(|error| file::unreadable(&Disk, path, &error.into()))?;
    let PreparedLight { photons, radiosity } = PreparedLight::parse(&bytes).map_err(|error| match error {
        LightFileError::NotWrittenByDurer | LightFileError::WrittenByPovRay => {
            unreadable("was not written by `durer prepare`")
        }
        LightFileError::OtherKind => unreadable("was saved by a scene; its `load_file` reads the file"),
        LightFileError::OtherVersion => unreadable("was written by another version of durer"),
        LightFileError::Damaged => unreadable("is damaged or cut off"),
    })?;
    let digests = render::photon_and_radiosity_digests(world, options);
    for ((saved, light), digest) in
        saved_photons_and_radiosity(world).into_iter().zip([photons, radiosity]).zip(digests)
    {
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

/// Returns the World's settings of photons and of radiosity samples that are loaded or to be saved; `None` for light that
/// the World does not compute.
fn saved_photons_and_radiosity(world: &mut World) -> [Option<&mut SavedLight>; 2] {
    [
        world.photon_map.as_mut().map(|settings| &mut settings.saved),
        world.radiosity.as_mut().map(|settings| &mut settings.saved),
    ]
}

/// Kinds of light in the order of their computation.
const LIGHT_KINDS: [LightKind; 2] = [LightKind::Photons, LightKind::Radiosity];

/// True if light is loaded that the computation with this digest has saved; false if the digest is `None`, since it was
/// not computed.
fn loaded_light_matches_computation(saved: &SavedLight, computation: Option<Digest>) -> bool {
    let computation_of_loaded = saved.loaded.as_ref().map(|loaded| loaded.file.header.computation);
    computation_of_loaded.is_some() && computation_of_loaded == computation
}

/// Loads light from a journal, if the computation with this digest has stored the light whole. Returns true if it is loaded.
fn try_load_from_journal(
    saved: &mut SavedLight,
    journal: &Journal,
    kind: LightKind,
    computation: Option<Digest>,
) -> bool {
    let file = journal.load_light(kind).and_then(|bytes| LightFile::parse(bytes, kind).ok());
    let Some(file) = file.filter(|file| Some(file.header.computation) == computation) else { return false };
    let name = journal.path().to_string_lossy().into_owned();
    saved.loaded = Some(LoadedLight { file, name, source: Span::NONE });
    true
}

/// Writes photons and radiosity samples to files and to the journal of a picture.
pub struct LightSaver {
    /// Policy for files that a scene names.
    sandbox: Sandbox,
    journal: Option<JournalOfLight>,
    warnings: Mutex<Vec<Diagnostic>>,
}

/// Journal that photons and radiosity samples are written to.
struct JournalOfLight {
    journal: Arc<Journal>,
    /// Moment from which light is worth storing: its computation has taken long.
    begins: Option<Instant>,
    /// Kinds of light to store, each with the file that the scene or the command line names for it.
    kinds: Vec<(LightKind, Option<SaveFile>)>,
}

impl ReceiveLight for LightSaver {
    /// Writes light to the journal, if its computation has taken long, and to its file.
    fn receive(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) {
        let stored = self.journal.iter().find_map(|JournalOfLight { journal, begins, kinds }| {
            let (_, named) = kinds.iter().find(|(kind, _)| *kind == file.kind)?;
            Some((journal, begins.is_some_and(|begins| Instant::now() >= begins), named))
        });
        let Some((journal, is_worth_storing, named)) = stored else { return self.save(file, write) };
        if is_worth_storing {
            journal.store_light(file.kind, write);
        }
        named.iter().for_each(|named| self.save(named, write));
    }
}

impl LightSaver {
    /// Creates a saver; `sandbox` is the policy for files that the scene names.
    pub fn new(sandbox: Sandbox) -> Self {
        Self { sandbox, journal: None, warnings: Mutex::default() }
    }

    /// Uses the light in the journal of a picture, and stores other light in the journal if its computation takes longer
    /// than `min_duration`. Light in the journal that is incomplete or damaged is computed.
    pub fn use_journal(
        &mut self,
        journal: &Arc<Journal>,
        world: &mut World,
        options: &render::Options,
        min_duration: Duration,
    ) {
        // The digests of a large scene take time.
        let is_loaded = |saved: &Option<&mut SavedLight>| saved.as_ref().is_some_and(|saved| saved.loaded.is_some());
        let needs_digests = journal.has_light() || saved_photons_and_radiosity(world).iter().any(is_loaded);
        let digests =
            if needs_digests { render::photon_and_radiosity_digests(world, options).map(Some) } else { [None; 2] };
        let mut kinds = vec![];
        for ((kind, saved), digest) in LIGHT_KINDS.into_iter().zip(saved_photons_and_radiosity(world)).zip(digests) {
            let Some(saved) = saved else { continue };
            if !loaded_light_matches_computation(saved, digest) && !try_load_from_journal(saved, journal, kind, digest)
            {
                let file = SaveFile { kind, path: journal.path().to_path_buf(), source: Span::NONE };
                kinds.push((kind, saved.save.replace(file)));
            }
        }
        let begins = Instant::now().checked_add(min_duration);
        self.journal = Some(JournalOfLight { journal: journal.clone(), begins, kinds });
    }

    /// Saves light to a file. A file that cannot be written gives a warning, because the picture does not depend on the
    /// file.
    fn save(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) {
        let saved = match file.source {
            Span::NONE => save_to_user_path(&file.path, file.kind, write),
            _ => self.save_to_scene_path(file, write),
        };
        self.warnings.lock().unwrap_or_else(PoisonError::into_inner).extend(saved.err().map(|warning| *warning));
    }

    /// Returns the warnings about files that could not be written.
    pub fn warnings(&self) -> Vec<Diagnostic> {
        self.warnings.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Saves photons or radiosity samples to a file that the scene names, if the policy for the scene's files allows
    /// that.
    fn save_to_scene_path(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) -> Result<()> {
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

/// Saves photons or radiosity samples to a file that the command line names. An existing file is replaced only if it is
/// empty or contains such saved light.
fn save_to_user_path(path: &Path, kind: LightKind, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) -> Result<()> {
    let save = || {
        if Disk.exists(path) && !is_light_file_or_empty(&Disk.read(path)?) {
            return Err(io::Error::other("the file exists, and durer did not save it"));
        }
        let mut draft = Disk.draft(path)?;
        write(&mut draft)?;
        draft.commit(&Disk)
    };
    save().map_err(|error| unsaved_warning(kind, path, Span::NONE, &error).into())
}

fn unsaved_warning(kind: LightKind, path: &Path, source: Span, error: &io::Error) -> Diagnostic {
    let text = format!("the {} were not saved to `{}`: {}", kind.plural_name(), path.display(), file::reason(error));
    Diagnostic::new(codes::UNSAVED_LIGHT, source, text)
}
