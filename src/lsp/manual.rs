//! Addresses of the manual on this machine: in the folder `DURER_MANUAL` (the manual's `src`), in `share/doc/durer`
//! beside the program's folder, or in the source tree that contains the program.

use super::document::uri_of;
use crate::diagnostic::codes;
use lsp_types::Uri;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::OnceLock;

/// A file that identifies the manual's folder.
const SUMMARY: &str = "SUMMARY.md";

fn folder() -> Option<&'static Path> {
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    let is_manual = |path: &PathBuf| path.join(SUMMARY).is_file();
    let find = || {
        if let Some(given) = std::env::var_os("DURER_MANUAL") {
            return Some(PathBuf::from(given)).filter(is_manual);
        }
        let program = std::env::current_exe().ok()?;
        let around = program.ancestors().skip(1).take(4);
        around.flat_map(|place| [place.join("share/doc/durer"), place.join("docs/src")]).find(is_manual)
    };
    FOLDER.get_or_init(find).as_deref()
}

/// Returns the address of a page of the manual; `None` if the manual is not installed.
fn address(path: &str) -> Option<Uri> {
    let path = folder()?.join(path);
    path.is_file().then(|| uri_of(&path)).flatten()
}

/// Returns the address of the manual's picture of a word.
pub fn picture(word: &str) -> Option<Uri> {
    address(&format!("pictures/reference/{word}.png"))
}

/// Returns the address of the manual's explanation of a diagnostic code.
pub fn code_address(code: &str) -> Option<Uri> {
    let page = address("reference/codes.md")?;
    let heading = format!("{code}: {}", codes::find_explanation(code)?.title).to_lowercase();
    let characters = heading.chars().filter(|c| c.is_ascii_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    let anchor: String = characters.map(|c| if c == ' ' { '-' } else { c }).collect();
    Uri::from_str(&format!("{}#{anchor}", page.as_str())).ok()
}
