//! `durer watch`: a page on the loopback address that shows a scene's picture while the scene is edited.
//!
//! The front end renders, and this module displays. A [`Screen`] holds the picture and the text beside it. Each page
//! receives the changes since its last update (`stream`), so that an inactive page costs nothing and a reloaded page is
//! complete. `levels` renders from coarse to fine. Requests of a page go to the [`Backend`]. `guard` admits only the
//! page's own script, and the server never serves a file.

mod file_watcher;
mod guard;
mod http;
mod levels;
mod screen;
mod serve;
mod stream;

pub use file_watcher::FileWatcher;
pub use levels::render_levels_timing_first;
pub use screen::Screen;
pub use serve::serve;

use serde::{Deserialize, Serialize};

/// The renderer that serves the preview page.
pub trait Backend: Send + Sync {
    /// Changes the settings of the picture.
    fn change(&self, change: Change);
    /// Describes the object that a pixel of the displayed picture shows, as JSON.
    fn pick(&self, x: usize, y: usize) -> serde_json::Value;
    /// Writes the picture to its file, and returns the file's name.
    ///
    /// # Errors
    /// The reason, as text for the page.
    fn save(&self) -> Result<String, String>;
    /// Opens a position of the scene's texts in the author's editor.
    ///
    /// # Errors
    /// The reason, as text for the page.
    fn open(&self, position: &TextPosition) -> Result<(), String>;
}

/// Settings of the picture on the preview page.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PageSettings {
    /// Factor by which the preview's picture is scaled.
    pub scale: f64,
    /// True if the preview anti-aliases its picture.
    pub antialias: bool,
    /// Quality of the preview's picture from 0 to 11, as `--quality`.
    pub quality: u8,
    /// Value of `clock` on the page, in place of the command line's.
    pub clock: Option<f64>,
    /// Left, top, width and height of the part that fills the picture, as fractions of its size.
    pub zoom: Option<[f64; 4]>,
}

/// A change of [`PageSettings`]; absent fields stay the same.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Change {
    scale: Option<f64>,
    antialias: Option<bool>,
    quality: Option<u8>,
    clock: Option<f64>,
    /// Left, top, width and height of the displayed part as fractions of the picture's size; an empty list for the
    /// whole picture.
    zoom: Option<Vec<f64>>,
}

impl Change {
    /// True if the change of the preview's settings affects only the rendering, so that the scene need not be evaluated
    /// again.
    pub fn keeps_scene(&self) -> bool {
        self.scale.is_none() && self.clock.is_none()
    }
}

impl PageSettings {
    /// Applies a change to the preview's settings; values out of range are ignored or limited.
    pub fn apply(&mut self, change: &Change) {
        if let Some(scale) = change.scale.filter(|scale| (0.05..=8.0).contains(scale)) {
            self.scale = scale;
        }
        self.antialias = change.antialias.unwrap_or(self.antialias);
        self.quality = change.quality.map_or(self.quality, |quality| quality.min(11));
        self.clock = change.clock.filter(|clock| clock.is_finite()).or(self.clock);
        match change.zoom.as_deref() {
            Some([]) => self.zoom = None,
            Some(&[x, y, width, height]) if is_within_unit_interval(x, width) && is_within_unit_interval(y, height) => {
                self.zoom = Some([x, y, width, height]);
            }
            _ => {}
        }
    }
}

fn is_within_unit_interval(at: f64, length: f64) -> bool {
    (0.0..1.0).contains(&at) && length > 0.0 && at + length <= 1.0 + 1e-9
}

/// A position in one of the scene's texts.
#[derive(Clone, Debug, Deserialize)]
pub struct TextPosition {
    /// Name of the source file as in messages.
    pub file: String,
    /// Line of the text position, counted from 1.
    pub line: usize,
    /// Column of the text position, counted from 1.
    pub column: usize,
}

/// State of the work, which the page displays beside the picture.
#[derive(Clone, Debug, Serialize)]
pub struct PageState {
    /// Name of the previewed scene.
    pub name: String,
    /// State of the page: `reading`, `drawing`, `done` or `broken`; a broken scene leaves the previous picture on the
    /// page.
    pub status: &'static str,
    /// Settings of the page for the previewed picture.
    pub settings: PageSettings,
    /// Width and height of the previewed picture at scale 1.
    pub size: [usize; 2],
    /// Present, first and last value of `clock` on the page.
    pub clock: [f64; 3],
    /// Messages about the previewed scene, errors first.
    pub messages: Vec<Message>,
    /// Output of the scene's `#debug` and its kin.
    pub log: String,
    /// Names of the rendering's steps and their durations in seconds.
    pub times: Vec<(&'static str, f64)>,
    /// Number of rays traced for the previewed picture.
    pub rays: u64,
    /// True if the server opens positions in an editor; otherwise the page follows their links.
    pub editor: bool,
}

/// One message of a run, as the preview page shows it.
#[derive(Clone, Debug, Serialize)]
pub struct Message {
    /// Severity of the message: `error` or `warning`.
    pub severity: &'static str,
    /// Code of the message, such as `E0203`.
    pub code: &'static str,
    /// The message with its source lines and help, as on a terminal.
    pub text: String,
    /// Position of the message in the scene's text.
    pub place: Option<Link>,
}

/// A position in a scene's text that the page can open.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Link {
    /// Name of the link's source file as in messages.
    pub file: String,
    /// Line that the link opens in an editor, counted from 1.
    pub line: usize,
    /// Column that the link opens in an editor, counted from 1.
    pub column: usize,
    /// Address that opens the position in Visual Studio Code.
    pub url: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_take_valid_changes_only() {
        let old = PageSettings { scale: 1.0, antialias: true, quality: 9, clock: None, zoom: None };
        let after = |json: &str| {
            let mut new = old.clone();
            new.apply(&serde_json::from_str(json).unwrap());
            new
        };
        assert_eq!(after("{}"), old);
        assert_eq!(after(r#"{"scale": 0.5, "quality": 200}"#), PageSettings { scale: 0.5, quality: 11, ..old.clone() });
        assert_eq!(after(r#"{"scale": 1e9, "clock": 0.25}"#), PageSettings { clock: Some(0.25), ..old.clone() });
        assert_eq!(after(r#"{"zoom": [0.5, 0, 0.5, 0.5]}"#).zoom, Some([0.5, 0.0, 0.5, 0.5]));
        for none in ["[]", "[0, 0, 0, 1]", "[0.6, 0, 0.5, 0.5]", "[-1, 0, 0.5, 0.5]", "[0, 0, 1]"] {
            assert_eq!(after(&format!(r#"{{"zoom": {none}}}"#)).zoom, None, "{none}");
        }
    }
}
