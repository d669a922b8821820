//! Rules for the files that an INI file names. The INI file may come from another person than the one who starts durer.

use super::{Origin, Translation, table::Row};
use crate::diagnostic::{Diagnostic, codes};
use std::path::{Component, Path};

impl Translation<'_> {
    /// Checks a setting of an INI file that names files or folders. If the setting is ignored because the INI file is
    /// untrusted, adds a warning and returns true. False for options of the command line.
    ///
    /// # Errors
    /// E0235 if the name of the picture or of the radiosity's file, or of one of their folders, begins with a dot.
    pub(super) fn ignores_with_warning(
        &mut self,
        row: &Row,
        text: &str,
        value: &str,
        origin: Origin,
    ) -> Result<bool, Diagnostic> {
        let path = Path::new(value);
        if origin.word.is_none() {
            return Ok(false);
        }
        let hidden = match row.ini {
            _ if !is_hidden(path) => None,
            "Output_File_Name" => Some(("picture", "-o")),
            "Radiosity_File_Name" => Some(("radiosity", "--save-radiosity")),
            _ => None,
        };
        if let Some((contents, option)) = hidden {
            let text = format!("the INI file names `{value}` for its {contents}, a file that begins with a dot");
            let fault = Diagnostic::new(codes::FORBIDDEN_FILE, origin.value, text);
            return Err(fault.help(format!("`{option}` on the command line takes any name")));
        }
        let reason = match row.ini {
            _ if !self.files.is_untrusted() => return Ok(false),
            "Library_Path" => "an untrusted INI file opens no folders",
            "Radiosity_From_File" | "Radiosity_To_File" => "an untrusted INI file neither loads nor saves radiosity",
            "Output_File_Name" if !is_plain_name(path) => "an untrusted INI file names its picture without a folder",
            _ => return Ok(false),
        };
        let message = format!("`{text}` has no effect: {reason}");
        self.faults.push(Diagnostic::new(codes::OPTION_IGNORED, origin.word, message));
        Ok(true)
    }
}

/// True if the name of a file or of one of its folders begins with a dot.
fn is_hidden(path: &Path) -> bool {
    path.components().any(|part| matches!(part, Component::Normal(name) if name.to_string_lossy().starts_with('.')))
}

/// True for the name of a file in the current folder.
pub(super) fn is_plain_name(path: &Path) -> bool {
    matches!(path.components().collect::<Vec<_>>()[..], [Component::Normal(_)])
}
