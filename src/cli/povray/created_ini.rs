//! The INI file of `Create_Ini`, which holds all settings of a command line.

use super::table::{Row, Takes};

/// Settings of a command line by their INI names.
#[derive(Clone, Debug, Default)]
pub struct NamedSettings(Vec<(&'static str, String)>);

/// INI names of settings that an INI file may state several times, because every value applies and not only the last.
const REPEATED: &[&str] = &["Declare", "Library_Path"];

/// INI names of on/off settings whose option can also state a value, each with the INI name of the setting for that
/// value.
const NAMES_OF_VALUES: &[(&str, &str)] = &[
    ("Antialias", "Antialias_Threshold"),
    ("Bounding", "Bounding_Threshold"),
    ("Buffer_Output", "Buffer_Size"),
    ("Dither", "Dither_Method"),
    ("Jitter", "Jitter_Amount"),
    ("Output_to_File", "Output_File_Type"),
    ("Test_Abort", "Test_Abort_Count"),
    ("All_Console", "All_File"),
    ("Debug_Console", "Debug_File"),
    ("Fatal_Console", "Fatal_File"),
    ("Render_Console", "Render_File"),
    ("Statistic_Console", "Statistic_File"),
    ("Warning_Console", "Warning_File"),
];

/// INI names whose value is written without quotes, although it is a text.
const UNQUOTED: &[&str] = &["Declare", "Dither_Method", "File_Gamma", "Display_Gamma"];

impl NamedSettings {
    /// Adds a POV-Ray option that was read to the settings: its value, or whether it was turned on.
    pub fn add(&mut self, row: &Row, value: &str, on: bool) {
        if row.ini.is_empty() {
            return;
        }
        match row.takes {
            Takes::Text if row.ini == "Output_File_Type" => self.set_file_type(value),
            Takes::Number | Takes::Text => self.set(row.ini, value, row.takes == Takes::Text),
            Takes::MaybeText if row.switch.is_empty() => self.set(row.ini, value, true),
            Takes::Nothing | Takes::MaybeNumber | Takes::MaybeText => {
                self.set(row.ini, if on { "On" } else { "Off" }, false);
                let name = NAMES_OF_VALUES.iter().find(|(name, _)| *name == row.ini).map(|(_, of_value)| *of_value);
                match name {
                    Some("Output_File_Type") => self.set_file_type(value),
                    Some(name) if !value.is_empty() => self.set(name, value, row.takes == Takes::MaybeText),
                    _ => {}
                }
            }
        }
    }

    /// Sets the INI settings that a file type such as `N16` or `Ng` names: format, grayscale, and bits per
    /// channel.
    fn set_file_type(&mut self, value: &str) {
        let Some(letter) = value.get(..1) else { return };
        self.set("Output_File_Type", letter, false);
        match &value[1..] {
            "" => {}
            "g" | "G" => self.set("Grayscale_Output", "On", false),
            bits => self.set("Bits_Per_Color", bits, false),
        }
    }

    fn set(&mut self, name: &'static str, value: &str, is_text: bool) {
        if !REPEATED.contains(&name) {
            self.0.retain(|(other, _)| *other != name);
        }
        let is_quoted = is_text && !UNQUOTED.contains(&name);
        self.0.push((name, if is_quoted { format!("\"{value}\"") } else { value.into() }));
    }

    /// Adds a setting that has its default value, unless it was read.
    pub fn add_default(&mut self, name: &'static str, value: &str) {
        if self.0.iter().all(|(other, _)| *other != name) {
            self.0.push((name, value.into()));
        }
    }

    /// Returns the lines of the INI file in the order of the names.
    pub fn lines(mut self) -> String {
        // The sort is stable: repeated settings keep their order.
        self.0.sort_by_key(|(name, _)| *name);
        self.0.into_iter().map(|(name, value)| format!("{name}={value}\n")).collect()
    }
}
