//! `durer watch`: a page on the loopback address that shows a scene's picture while it is written.
//!
//! The front end draws; this module shows. A [`Screen`] holds the picture and what is told beside it; each page that looks is sent
//! what it has not seen yet (`stream`), so that one that sleeps costs nothing and one that is loaded again misses nothing. `levels`
//! draws from coarse to fine. What a page asks for goes to the [`Studio`]. `guard` lets nobody in but the page's own script, and no
//! file is ever served.

mod files;
mod guard;
mod http;
mod levels;
mod screen;
mod serve;
mod stream;

pub use files::Files;
pub use levels::draw;
pub use screen::Screen;
pub use serve::serve;

use serde::{Deserialize, Serialize};

/// Whoever draws, and knows the scene.
pub trait Studio: Send + Sync {
    /// The page wants something else.
    fn change(&self, change: Change);
    /// What is seen through a pixel of the picture that is shown, as JSON.
    fn pick(&self, x: usize, y: usize) -> serde_json::Value;
    /// Writes the picture to its file, and tells its name.
    ///
    /// # Errors
    /// Why it can't, in words.
    fn save(&self) -> Result<String, String>;
    /// Opens a place of the scene's texts in the author's editor.
    ///
    /// # Errors
    /// Why it can't, in words.
    fn open(&self, place: &Spot) -> Result<(), String>;
}

/// How the page wants the picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Settings {
    /// The picture's size is multiplied by this.
    pub scale: f64,
    /// Is anti-aliasing on?
    pub antialias: bool,
    /// 0 to 11, as `--quality`.
    pub quality: u8,
    /// The value of `clock`, if it is not what the command line says.
    pub clock: Option<f64>,
    /// Left, top, width and height of the part that is drawn as large as the picture, in shares of it.
    pub zoom: Option<[f64; 4]>,
}

/// What of the settings changes.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Change {
    scale: Option<f64>,
    antialias: Option<bool>,
    quality: Option<u8>,
    clock: Option<f64>,
    /// Four numbers, or none for the whole picture.
    zoom: Option<Vec<f64>>,
}

impl Change {
    /// Does it change nothing but how the scene is drawn?
    pub fn keeps_scene(&self) -> bool {
        self.scale.is_none() && self.clock.is_none()
    }
}

impl Settings {
    /// Takes what makes sense.
    pub fn take(&mut self, change: &Change) {
        if let Some(scale) = change.scale.filter(|scale| (0.05..=8.0).contains(scale)) {
            self.scale = scale;
        }
        self.antialias = change.antialias.unwrap_or(self.antialias);
        self.quality = change.quality.map_or(self.quality, |quality| quality.min(11));
        self.clock = change.clock.filter(|clock| clock.is_finite()).or(self.clock);
        match change.zoom.as_deref() {
            Some([]) => self.zoom = None,
            Some(&[x, y, width, height]) if is_part(x, width) && is_part(y, height) => {
                self.zoom = Some([x, y, width, height]);
            }
            _ => {}
        }
    }
}

fn is_part(at: f64, length: f64) -> bool {
    (0.0..1.0).contains(&at) && length > 0.0 && at + length <= 1.0 + 1e-9
}

/// A place in one of the scene's texts.
#[derive(Clone, Debug, Deserialize)]
pub struct Spot {
    /// As messages name it.
    pub file: String,
    /// From 1.
    pub line: usize,
    /// From 1.
    pub column: usize,
}

/// What stands beside the picture.
#[derive(Clone, Debug, Serialize)]
pub struct Told {
    /// The scene's name.
    pub name: String,
    /// `reading`, `drawing`, `done`, or `broken`: the picture is then that of before.
    pub status: &'static str,
    /// What the page wanted.
    pub settings: Settings,
    /// Width and height of the picture at scale 1.
    pub size: [usize; 2],
    /// The clock's value now, and where it begins and ends.
    pub clock: [f64; 3],
    /// Errors first.
    pub messages: Vec<Message>,
    /// What the scene prints.
    pub log: String,
    /// What was done, and for how many seconds.
    pub times: Vec<(&'static str, f64)>,
    /// Rays that were cast.
    pub rays: u64,
    /// Does the server open places in an editor? Otherwise the page follows their links.
    pub editor: bool,
}

/// One message of a run.
#[derive(Clone, Debug, Serialize)]
pub struct Message {
    /// `error` or `warning`.
    pub severity: &'static str,
    /// Such as `E0203`.
    pub code: &'static str,
    /// The message, the lines that it is about, and help, as on a terminal.
    pub text: String,
    /// Where it is, if it is anywhere.
    pub place: Option<Link>,
}

/// A place that a page can open.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Link {
    /// As messages name it.
    pub file: String,
    /// From 1.
    pub line: usize,
    /// From 1.
    pub column: usize,
    /// What opens it in Visual Studio Code.
    pub url: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_take_what_makes_sense() {
        let old = Settings { scale: 1.0, antialias: true, quality: 9, clock: None, zoom: None };
        let after = |json: &str| {
            let mut new = old.clone();
            new.take(&serde_json::from_str(json).unwrap());
            new
        };
        assert_eq!(after("{}"), old);
        assert_eq!(after(r#"{"scale": 0.5, "quality": 200}"#), Settings { scale: 0.5, quality: 11, ..old.clone() });
        assert_eq!(after(r#"{"scale": 1e9, "clock": 0.25}"#), Settings { clock: Some(0.25), ..old.clone() });
        assert_eq!(after(r#"{"zoom": [0.5, 0, 0.5, 0.5]}"#).zoom, Some([0.5, 0.0, 0.5, 0.5]));
        for none in ["[]", "[0, 0, 0, 1]", "[0.6, 0, 0.5, 0.5]", "[-1, 0, 0.5, 0.5]", "[0, 0, 1]"] {
            assert_eq!(after(&format!(r#"{{"zoom": {none}}}"#)).zoom, None, "{none}");
        }
    }
}
