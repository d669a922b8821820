//! Translates POV-Ray's command line into durer's own: `durer +Iscene.pov +W640 +H480 +A0.3` becomes `durer render
//! --aa=0.3 --size=640x480 -- scene.pov`. As in POV-Ray, anti-aliasing is off without `+A`, INI files may appear
//! between other words, and the later of two contradicting words counts.

pub mod client_lines;
mod created_ini;
mod files;
mod ini;
mod ini_trust;
mod mixed;
mod number;
mod own;
mod settings;
pub(super) mod table;
#[cfg(test)]
mod tests;
mod text_options;
pub mod text_output;

use super::animation::Animation;
use super::args::environment_is_untrusted;
use crate::diagnostic::{Diagnostic, codes, nearest};
use crate::source::{Sources, Span};
use created_ini::NamedSettings;
pub use files::is_ini;
use files::{Files, input_or_pov_file};
pub use mixed::first_index_and_word;
use own::DurerOption;
use settings::Settings;
use std::ffi::OsString;
use std::iter::Peekable;
use std::path::{Path, PathBuf};
use table::{Effect, ROWS, Row, Takes};
use text_options::TextOptions;
use text_output::TextOutput;

/// Result of translating POV-Ray's options to durer's.
#[derive(Debug, Default)]
pub struct Translated {
    /// Command line in durer's own options.
    pub words: Vec<OsString>,
    /// Animation that POV-Ray's options describe and durer's options cannot express.
    pub animation: Option<Animation>,
    /// Errors, and warnings about ignored options, with positions in the INI files of [`Sources`].
    pub diagnostics: Vec<Diagnostic>,
    /// Warnings about options without effect in durer, for `--warn options`.
    pub idle: Vec<Diagnostic>,
    /// True for a command line of POV-Ray, without a command of durer.
    pub is_povray_line: bool,
    /// Text output that POV-Ray's command line asks for.
    pub text_output: TextOutput,
}

/// Translates a command line of POV-Ray, or the POV-Ray options after a durer command. A command line of durer alone is
/// returned unchanged.
pub fn translate(sources: &Sources, words: Vec<OsString>) -> Translated {
    if let [program, word] = &words[..]
        && ["-?", "+?", "-H", "+H", "-HELP"].iter().any(|help| word.eq_ignore_ascii_case(help))
    {
        return Translated { words: vec![program.clone(), "--help".into()], ..Translated::default() };
    }
    if asks_version(&words) {
        return Translated { words: vec!["durer".into(), "--version".into()], ..Translated::default() };
    }
    let untrusted = environment_is_untrusted() || words.iter().any(|word| word == "--untrusted");
    let form = if is_named_povray(&words) && words.len() == 1 {
        mixed::Form::Povray
    } else {
        mixed::command_line_form(&words)
    };
    match form {
        mixed::Form::Durer => Translated { words, ..Translated::default() },
        mixed::Form::Mixed(at) => Translation::new(sources, untrusted).translate_mixed(&words, at),
        mixed::Form::Povray => {
            let reads_no_ini = untrusted || words.iter().any(|word| word == NO_INI);
            let user_ini = if reads_no_ini { None } else { user_ini() };
            let mut translation = Translation::of_line(sources, &words, untrusted, None);
            if translation.any_switch && user_ini.is_some() {
                translation = Translation::of_line(sources, &words, untrusted, user_ini.as_deref());
            }
            translation.settings.is_povray_line = translation.any_switch && translation.command.is_none();
            translation.add_missing_scene_error();
            translation.into_translated(words.first().cloned().unwrap_or_default())
        }
    }
}

/// True for a command line that asks POV-Ray for its version. True for `--version` if durer is called `povray`.
pub fn asks_version(words: &[OsString]) -> bool {
    let [_, word] = words else { return false };
    ["-version", "--V"].iter().any(|version| word == version) || word == "--version" && is_named_povray(words)
}

/// True if durer is called by the name `povray`. All command lines without a command of durer are then POV-Ray's.
pub fn is_named_povray(words: &[OsString]) -> bool {
    let stem = words.first().and_then(|program| Path::new(program).file_stem());
    stem.is_some_and(|stem| stem.eq_ignore_ascii_case("povray"))
}

/// Option on POV-Ray's command line that prevents durer from reading the user's INI file.
const NO_INI: &str = "--no-ini";

/// Returns the INI file that POV-Ray reads before its command line: the file in the environment variable `POVINI`, else
/// `povray.ini` in the current folder, else the one in the user's home folder.
fn user_ini() -> Option<PathBuf> {
    let in_home = |home| Path::new(&home).join(".povray/3.7/povray.ini");
    let candidates = [
        std::env::var_os("POVINI").map(PathBuf::from),
        Some("povray.ini".into()),
        std::env::var_os("HOME").map(in_home),
    ];
    candidates.into_iter().flatten().find(|path| path.is_file())
}

/// Translates an INI file into a command line. An untrusted one may name only scenes and INI files below its folder.
pub fn translate_ini(sources: &Sources, name: &Path, untrusted: bool) -> Translated {
    let mut translation = Translation::new(sources, untrusted);
    translation.read_ini_file(&name.to_string_lossy(), Origin::default());
    if translation.settings.input.is_none() && translation.faults.is_empty() {
        let message = format!("`{}` names no scene", name.display());
        let help = format!("add a line `Input_File_Name=scene.pov`, or name both: durer scene.pov {}", name.display());
        translation.faults.push(Diagnostic::new(codes::NO_SCENE, Span::NONE, message).help(help));
    }
    translation.into_translated("durer".into())
}

struct Translation<'s> {
    settings: Settings,
    /// Scenes that the command line names without a switch. All are rendered, unless there are POV-Ray options: POV-Ray
    /// renders the last scene only.
    scenes: Vec<OsString>,
    /// Options of durer, in the order of the command line.
    options: Vec<DurerOption>,
    /// Name of the durer command, if the command line names one.
    command: Option<String>,
    /// True if an option on the command line has POV-Ray's form, or if durer is called `povray`.
    any_switch: bool,
    faults: Vec<Diagnostic>,
    idle: Vec<Diagnostic>,
    files: Files<'s>,
    /// All settings that were read, for `Create_Ini`.
    named: NamedSettings,
    /// Options about text that were read so far.
    text: TextOptions,
    /// Text output for POV-Ray's command line, after all words are translated.
    text_output: TextOutput,
}

/// Positions of a word in an INI file; no position for a word of the command line.
#[derive(Clone, Copy, Debug, Default)]
struct Origin {
    word: Span,
    value: Span,
}

impl<'s> Translation<'s> {
    fn new(sources: &'s Sources, untrusted: bool) -> Self {
        let files = Files::new(sources, untrusted);
        Self {
            settings: Settings::new(),
            scenes: Vec::new(),
            options: Vec::new(),
            command: None,
            any_switch: false,
            faults: Vec::new(),
            idle: Vec::new(),
            files,
            named: NamedSettings::default(),
            text: TextOptions::default(),
            text_output: TextOutput::default(),
        }
    }

    /// Translates the words of POV-Ray's command line after the program's name, and before them the INI file `ini`.
    fn of_line(sources: &'s Sources, words: &[OsString], untrusted: bool, ini: Option<&Path>) -> Self {
        let mut translation = Self::new(sources, untrusted);
        translation.any_switch = is_named_povray(words);
        ini.iter().for_each(|ini| translation.read_ini_file(&ini.to_string_lossy(), Origin::default()));
        let mut rest = words.iter().skip(1).filter(|word| *word != NO_INI).peekable();
        while let Some(word) = rest.next() {
            translation.translate_word(word, &mut rest);
        }
        translation
    }

    /// Translates a word of the command line, which may be a durer option whose value is the next word.
    fn translate_word<'a>(&mut self, word: &'a OsString, rest: &mut Peekable<impl Iterator<Item = &'a OsString>>) {
        let text = word.to_string_lossy().into_owned();
        match own::name_and_takes_next(&text, rest.peek().map(|next| next.to_string_lossy()).as_deref()) {
            Some((name, takes_value)) => {
                let words = std::iter::once(word).chain(rest.take(usize::from(takes_value))).cloned().collect();
                self.options.push(DurerOption { name, words });
            }
            // `durer +W8 check a.pov`
            None if self.command.is_none() && self.scenes.is_empty() && mixed::accepts_povray_words(&text) => {
                self.command = Some(text);
            }
            None => self.translate_option(&text, Origin::default()),
        }
    }

    /// Translates a switch, a setting, an INI file or a scene.
    fn translate_option(&mut self, text: &str, origin: Origin) {
        let text = strip_outer_quotes(text);
        let switch = text.strip_prefix(['+', '-']).filter(|rest| !rest.is_empty());
        let setting =
            text.split_once('=').filter(|(name, _)| name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'));
        let done = if let Some(rest) = switch {
            self.any_switch = true;
            find_switch(rest)
                .ok_or_else(|| unknown_option_error(text, origin))
                .and_then(|(row, value)| self.apply_option(row, text, value, text.starts_with('+'), origin))
        } else if let Some((name, value)) = setting {
            self.any_switch = true;
            let row = ROWS.iter().find(|row| !row.ini.is_empty() && row.ini.eq_ignore_ascii_case(name));
            row.ok_or_else(|| unknown_option_error(text, origin))
                .and_then(|row| self.translate_setting(row, text, value, origin))
        } else if self.files.is_ini(text) {
            self.any_switch = true;
            self.read_ini_file(text, origin);
            Ok(())
        } else if origin.word.is_none() {
            self.scenes.push(input_or_pov_file(self.files.scene_path(text)).into());
            Ok(())
        } else {
            self.set_input(text, origin)
        };
        self.faults.extend(done.err());
    }

    /// Adds an error if POV-Ray's command line names no scene.
    fn add_missing_scene_error(&mut self) {
        let has_scene = self.settings.input.is_some() || !self.scenes.is_empty();
        if self.settings.is_povray_line && !has_scene && self.faults.is_empty() {
            let fault = Diagnostic::new(codes::NO_SCENE, Span::NONE, "no input file provided");
            self.faults.push(fault.help("name the scene: `+Iscene.pov`"));
        }
    }

    /// Sets the scene to render, unless a later word names another one.
    fn set_input(&mut self, name: &str, origin: Origin) -> Result<(), Diagnostic> {
        let scene = self.files.scene_path(name);
        self.files
            .check_ini_may_name(Path::new(&input_or_pov_file(scene.clone())), origin.value)
            .map_err(|fault| *fault)?;
        let is_as_named = scene == name && !self.files.is_untrusted();
        self.settings.scene_folder = Path::new(name).parent().filter(|_| is_as_named).unwrap_or(Path::new("")).into();
        self.settings.input = Some(scene);
        self.scenes.clear();
        Ok(())
    }

    fn translate_setting(
        &mut self,
        row: &'static Row,
        text: &str,
        value: &str,
        origin: Origin,
    ) -> Result<(), Diagnostic> {
        let value = strip_outer_quotes(value);
        match (row.takes, parse_on_off(value)) {
            (Takes::MaybeText, _) if value.is_empty() && row.has_default_text_file() => {
                self.apply_option(row, text, "", true, origin)
            }
            (Takes::Text | Takes::MaybeText, _) if value.is_empty() => Ok(()),
            (Takes::Number | Takes::Text, _) => self.apply_option(row, text, value, true, origin),
            (_, Some(on)) => self.apply_option(row, text, "", on, origin),
            (Takes::Nothing, None) => Err(wrong_value_error(text, "it needs `on` or `off`", origin)),
            (Takes::MaybeNumber, None) if number::parse_number_prefix(value).is_none() => {
                Err(wrong_value_error(text, "it needs `on`, `off` or a number", origin))
            }
            _ => self.apply_option(row, text, value, true, origin),
        }
    }

    fn apply_option(&mut self, row: &Row, text: &str, value: &str, on: bool, origin: Origin) -> Result<(), Diagnostic> {
        let needs = match row.takes {
            Takes::Number if number::parse_number_prefix(value).is_none() => Some("a number"),
            Takes::Text if value.is_empty() => Some("a value, without a space before it"),
            _ => None,
        };
        if let Some(needs) = needs {
            return Err(wrong_value_error(text, &format!("it needs {needs}"), origin));
        }
        if self.ignores_with_warning(row, text, value, origin)? {
            return Ok(());
        }
        self.named.add(row, value, on);
        match if on { row.on } else { row.off } {
            Effect::Same => Ok(()),
            Effect::TextFile(stream) => {
                let name = if value.is_empty() && row.has_default_text_file() { stream.default_file() } else { value };
                self.add_text_file(stream, name, origin)
            }
            Effect::Silence(stream) => {
                self.record_silenced_stream(stream, origin);
                self.add_text_file(stream, value, origin)
            }
            Effect::Flag(flag) => {
                self.options.push(DurerOption::new(flag.into()));
                Ok(())
            }
            Effect::Option(name) => {
                check_if_declare(name, value).map_err(|reason| wrong_value_error(text, &reason, origin))?;
                let value = match name {
                    "--include" => self.files.folder_path(value),
                    "--language" => {
                        number::parse_number_prefix(value).unwrap_or_default().clamp(1.0, 100.0).to_string()
                    }
                    _ => value.into(),
                };
                self.options.push(DurerOption::new(format!("{name}={value}")));
                Ok(())
            }
            Effect::Whole(name, least, largest) => {
                let n = number::parse_whole_prefix(value)
                    .ok_or_else(|| wrong_value_error(text, "it needs a whole number", origin))?;
                let n = n.clamp(f64::from(least), f64::from(largest));
                self.options.push(DurerOption::new(format!("{name}={n}")));
                Ok(())
            }
            Effect::Idle(reason) => {
                let message = format!("`{text}` has no effect: {reason}");
                self.idle.push(Diagnostic::new(codes::OPTION_IGNORED, origin.word, message));
                Ok(())
            }
            Effect::Part(_) if row.ini == "Input_File_Name" => self.set_input(value, origin),
            Effect::Part(set) => {
                set(&mut self.settings, value).map_err(|reason| wrong_value_error(text, &reason, origin))
            }
            Effect::Lacks(reason) => {
                let message = format!("`{text}` has no effect: {reason}");
                self.faults.push(Diagnostic::new(codes::OPTION_IGNORED, origin.word, message));
                Ok(())
            }
        }
    }

    /// Translates the words of an INI file in place of its name.
    fn read_ini_file(&mut self, name: &str, origin: Origin) {
        match self.files.open_ini(name, origin.word) {
            Ok(ini) => {
                self.faults.extend(ini.faults);
                for word in ini.words {
                    self.translate_option(&word.text, Origin { word: word.span, value: word.value });
                }
                self.files.close_innermost_ini();
            }
            Err(fault) => self.faults.push(*fault),
        }
    }

    /// Returns the translated command line, which starts with the name `program`.
    fn into_translated(mut self, program: OsString) -> Translated {
        let command = self.command.take().unwrap_or("render".into());
        if let Some(scene) = self.scenes.last().map(PathBuf::from) {
            self.settings.scene_folder = scene.parent().unwrap_or(Path::new("")).into();
            self.settings.input = Some(scene.display().to_string());
        }
        self.translate_text_stream_options();
        let options = self.take_option_words(self.any_switch);
        let known = |word: &OsString| mixed::subcommand_accepts_word(&command, &word.to_string_lossy());
        let options: Vec<_> = options.into_iter().filter(|word| command == "render" || known(word)).collect();
        let mut words = vec![program, command.into()];
        words.extend(options);
        let animation = self.settings.animation();
        let input = self.settings.input.map(|input| input_or_pov_file(input).into());
        let skipped = if self.any_switch { self.scenes.len().saturating_sub(1) } else { 0 };
        let scenes: Vec<_> = match self.scenes.is_empty() {
            true => input.into_iter().collect(),
            false => self.scenes.into_iter().skip(skipped).collect(),
        };
        if !scenes.is_empty() {
            words.push("--".into());
            words.extend(scenes);
        }
        let is_povray_line = self.settings.is_povray_line;
        let (diagnostics, idle, text_output) = (self.faults, self.idle, self.text_output);
        Translated { words, animation, diagnostics, idle, is_povray_line, text_output }
    }

    /// Takes all options that were read, and returns them in durer's form. With `antialias_off_by_default`, anti-aliasing is
    /// off unless `+A` turns it on.
    fn take_option_words(&mut self, antialias_off_by_default: bool) -> Vec<OsString> {
        let options = own::drop_overridden(std::mem::take(&mut self.options));
        let is_named = |name: &str| options.iter().any(|o| o.name == name);
        // Without a picture file, `+FN` and its kin have no effect.
        let is_idle =
            |name: &str| is_named("--no-output") && ["--output", "--format", "--bit-depth", "--gray"].contains(&name);
        let parts = self.settings.durer_options(antialias_off_by_default).into_iter().map(DurerOption::new);
        // An option of durer's own overrides the default that anti-aliasing is off.
        let parts = parts.filter(|part| !is_named(&part.name) && !is_idle(&part.name));
        let parts: Vec<_> = parts.flat_map(|part| part.words).collect();
        parts.into_iter().chain(options.into_iter().flat_map(|o| o.words)).collect()
    }
}

/// Checks the value of `--declare` before durer's own parser does, which can't report the position in an INI file. Values
/// of other options are not checked here.
fn check_if_declare(option: &str, value: &str) -> Result<(), String> {
    match option {
        "--declare" => value.parse::<super::args::values::Declare>().map(drop),
        _ => Ok(()),
    }
}

/// Returns the INI names of all POV-Ray options.
pub fn ini_names() -> impl Iterator<Item = &'static str> {
    ROWS.iter().map(|row| row.ini).filter(|ini| !ini.is_empty())
}

/// Finds the option with the longest switch at the word's start, and returns the option and its value, the rest.
fn find_switch(word: &str) -> Option<(&'static Row, &str)> {
    // Try exact numbers first: `+H12abc` is a number, too, but `+HRx` is a misspelt `+HR`.
    find_switch_with(word, |value| value.parse::<f64>().is_ok())
        .or_else(|| find_switch_with(word, |value| number::parse_number_prefix(value).is_some()))
}

fn find_switch_with(word: &str, is_number: impl Fn(&str) -> bool) -> Option<(&'static Row, &str)> {
    let fits = |row: &&Row| {
        let head =
            word.get(..row.switch.len()).filter(|head| !head.is_empty() && head.eq_ignore_ascii_case(row.switch));
        let value = strip_outer_quotes(&word[head?.len()..]);
        let number = || value.is_empty() || is_number(value);
        let fits = match row.takes {
            Takes::Nothing => value.is_empty(),
            Takes::Number | Takes::MaybeNumber => number(),
            Takes::Text | Takes::MaybeText => true,
        };
        fits.then_some(value)
    };
    let found = ROWS.iter().filter_map(|row| fits(&row).map(|value| (row, value)));
    found.max_by_key(|(row, _)| row.switch.len())
}

/// Removes the quotes around a value, and none within it. As in POV-Ray, the closing quote may be missing.
fn strip_outer_quotes(value: &str) -> &str {
    let mut rest = value.chars();
    match rest.next() {
        Some(quote @ ('"' | '\'')) => rest.as_str().strip_suffix(quote).unwrap_or(rest.as_str()),
        _ => value,
    }
}

/// Parses a switch value: true for `on`, `true`, `yes` and `1`, false for `off`, `false`, `no` and `0`; `None` for others.
fn parse_on_off(value: &str) -> Option<bool> {
    let is = |words: [&str; 4]| words.iter().any(|w| w.eq_ignore_ascii_case(value));
    match () {
        () if is(["on", "true", "yes", "1"]) => Some(true),
        () if is(["off", "false", "no", "0"]) => Some(false),
        () => None,
    }
}

fn wrong_value_error(text: &str, reason: &str, origin: Origin) -> Diagnostic {
    Diagnostic::new(codes::UNKNOWN_OPTION, origin.value, format!("`{text}` is invalid: {reason}"))
}

fn unknown_option_error(text: &str, origin: Origin) -> Diagnostic {
    let (name, value) = text.split_once('=').map_or((text, ""), |(name, value)| (name, value));
    let near =
        nearest(name.trim_start_matches(['+', '-']), ini_names()).map(|ini| format!("did you mean `{ini}={value}`?"));
    let help = near.unwrap_or("`durer render --help` lists durer's options".into());
    Diagnostic::new(codes::UNKNOWN_OPTION, origin.word, format!("there is no option `{text}`")).help(help)
}
