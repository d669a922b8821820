//! Options about POV-Ray's streams of text and about `Create_Ini`, which POV-Ray's command line alone obeys.

use super::ini_trust::is_plain_name;
use super::text_output::{Stream, TextOutput};
use super::{Origin, Translation, wrong_value_error};
use crate::cli::povray::own::DurerOption;
use crate::diagnostic::{Diagnostic, codes};
use crate::source::Span;
use std::path::{Path, PathBuf};

/// Options about text that were read so far.
#[derive(Clone, Debug, Default)]
pub(super) struct TextOptions {
    /// Files for copies of streams, each with the position of the option.
    files: Vec<(Stream, String, Span)>,
    /// Streams that are not printed, each with the position of the option.
    silent: Vec<(Stream, Span)>,
}

impl Translation<'_> {
    /// Adds a file for a copy of a stream, in place of an earlier one; no file for an empty name. As in POV-Ray, the file is
    /// beside the picture.
    ///
    /// # Errors
    /// If the name contains a folder.
    pub(super) fn add_text_file(&mut self, stream: Stream, name: &str, origin: Origin) -> Result<(), Diagnostic> {
        if name.is_empty() {
            return Ok(());
        }
        if !is_plain_name(Path::new(name)) {
            let reason = "it needs the name of a file beside the picture, without a folder";
            return Err(wrong_value_error(name, reason, origin));
        }
        self.text.files.retain(|(of, ..)| *of != stream);
        self.text.files.push((stream, name.into(), origin.word));
        Ok(())
    }

    /// Records that an option turns off the printing of a stream of text.
    pub(super) fn record_silenced_stream(&mut self, stream: Stream, origin: Origin) {
        self.text.silent.push((stream, origin.word));
    }

    /// Translates the options about text, after all words are read: into `text_output` for POV-Ray's own command line. A
    /// command of durer gets `--quiet` for `-GA`, and warnings about the options without effect.
    pub(super) fn translate_text_stream_options(&mut self) {
        let TextOptions { files, silent } = std::mem::take(&mut self.text);
        if silent.iter().any(|(stream, _)| *stream == Stream::All) {
            self.options.push(DurerOption::new("--quiet".into()));
        }
        if self.settings.is_povray_line {
            self.text_output = self.povray_text_output(files, silent);
            return;
        }
        for (stream, name, at) in files {
            let message = format!("there is no file `{name}` for POV-Ray's {} text", stream.name());
            let help = "messages go to standard error, which can be redirected";
            self.idle.push(Diagnostic::new(codes::OPTION_IGNORED, at, message).help(help));
        }
        if self.settings.created_ini.is_some() {
            let message = "`Create_Ini` has no effect: a command of durer writes no INI file";
            self.idle.push(Diagnostic::new(codes::OPTION_IGNORED, Span::NONE, message));
        }
        self.warn_streams_stay_printed(
            silent.into_iter().filter(|(stream, _)| [Stream::Debug, Stream::Warning].contains(stream)),
        );
    }

    /// Warns that streams are printed although an option turns them off.
    fn warn_streams_stay_printed(&mut self, streams: impl Iterator<Item = (Stream, Span)>) {
        for (stream, at) in streams {
            let message = format!("POV-Ray's {} text is printed all the same", stream.name());
            self.faults.push(Diagnostic::new(codes::OPTION_IGNORED, at, message).help("`-GA` prints errors alone"));
        }
    }

    /// Returns the text output of POV-Ray's command line.
    fn povray_text_output(&mut self, files: Vec<(Stream, String, Span)>, silent: Vec<(Stream, Span)>) -> TextOutput {
        self.warn_streams_stay_printed(silent.iter().copied().filter(|(stream, _)| *stream == Stream::Fatal));
        let silent = silent.into_iter().map(|(stream, _)| stream).collect();
        if self.files.is_untrusted() {
            for (_, name, at) in files {
                let message = format!("`{name}` is not written: an untrusted command writes its picture alone");
                self.faults.push(Diagnostic::new(codes::OPTION_IGNORED, at, message));
            }
            return TextOutput { silent, ..TextOutput::default() };
        }
        let folder = self.settings.output_folder();
        TextOutput {
            files: files.into_iter().map(|(stream, name, _)| (stream, folder.join(name))).collect(),
            appends: self.settings.appends_text,
            silent,
            ini: self.settings.created_ini.take().map(|path| (PathBuf::from(path), self.ini_text())),
        }
    }

    /// Returns all settings as the lines of an INI file.
    fn ini_text(&mut self) -> String {
        let mut named = std::mem::take(&mut self.named);
        for (name, value) in [("Height", "480"), ("Width", "640"), ("Output_File_Type", "N"), ("Output_to_File", "On")]
        {
            named.add_default(name, value);
        }
        if let Some(input) = &self.settings.input {
            named.add_default("Input_File_Name", &format!("\"{input}\""));
        }
        named.lines()
    }
}
