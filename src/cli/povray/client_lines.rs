//! Lines that programs look for in the standard error of POV-Ray. On POV-Ray's command line, durer prints them between
//! its own messages, unless standard error is a terminal.

use crate::cli::exit::Exit;
use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::source::Sources;
use std::time::Duration;

/// First line of the output for POV-Ray's clients, which read the version from the digits after `POV-Ray `.
pub const BANNER: &str = concat!("POV-Ray 3.7 compatible (durer ", env!("CARGO_PKG_VERSION"), ")\n");

/// Line that is printed before a scene is read.
pub const PARSING: &str = "==== [Parsing...] ==========================================================\n";

/// Line that is printed before a picture is rendered.
pub const RENDERING: &str = "==== [Rendering...] ========================================================\n";

/// Returns the line that `done` of `total` pixels are rendered. As in POV-Ray, the next progress overwrites the line.
pub fn progress_line(done: usize, total: usize) -> String {
    format!("Rendered {done} of {total} pixels ({}%)\r", done * 100 / total.max(1))
}

/// Line that separates the parts of POV-Ray's statistics.
const RULE: &str = "----------------------------------------------------------------------------\n";

/// Returns POV-Ray's statistics of a picture: width and height, and the times of parsing and tracing.
pub fn statistics([width, height]: [usize; 2], [parse, trace]: [Duration; 2]) -> String {
    let line = |name: &str, time: Duration| {
        let seconds = time.as_secs();
        let [hours, minutes, rest] = [seconds / 3600, seconds / 60 % 60, seconds % 60];
        let seconds = time.as_secs_f64();
        format!("  {name} Time: {hours:7} hours {minutes:2} minutes {rest:2} seconds ({seconds:.3} seconds)\n")
    };
    let times = line("Parse", parse) + &line("Trace", trace);
    format!("{RULE}Render Statistics\nImage Resolution {width} x {height}\n{RULE}{times}{RULE}")
}

/// Prefixes of the codes of warnings that POV-Ray does not have: about options without effect, and advice about pictures.
const NOT_OF_POVRAY: &[&str] = &["W001", "W04"];

/// Returns the line that POV-Ray prints for a diagnostic, with its file and line number; an empty text for the warnings
/// in [`NOT_OF_POVRAY`].
pub fn povray_diagnostic_line(sources: &Sources, diagnostic: &Diagnostic) -> String {
    if diagnostic.code == codes::UNKNOWN_OPTION {
        return "Problem with option setting\nFailed to parse command-line option\n".into();
    }
    if diagnostic.code == codes::NO_SCENE {
        return "Problem with option setting\nNo input file provided\n".into();
    }
    if NOT_OF_POVRAY.iter().any(|prefix| diagnostic.code.0.starts_with(prefix)) {
        return String::new();
    }
    let kind = match diagnostic.severity {
        Severity::Error => "Error",
        Severity::Warning => "Warning",
    };
    let message = diagnostic.message.lines().next().unwrap_or_default();
    match sources.place(diagnostic.span()) {
        Some(place) => format!("File '{}' line {}: Parse {kind}: {message}\n", place.file, place.line),
        None => format!("Parse {kind}: {message}\n"),
    }
}

/// Replaces the characters of durer's messages that are not ASCII, which some programs cannot decode. Characters of the
/// scene's text stay.
pub fn replace_message_symbols(text: &str) -> String {
    text.replace('…', "...")
        .replace('·', "*")
        .replace('×', "x")
        .replace('²', "^2")
        .replace(['“', '”'], "\"")
        .replace(['‘', '’'], "'")
}

/// Returns the last lines of the output for POV-Ray's clients, which state success, failure or cancellation.
pub fn ending_lines(exit: Exit) -> &'static str {
    match exit {
        Exit::Fine => "POV-Ray finished\n",
        Exit::Scene => "Fatal error in parser: Cannot parse input.\nRender failed\n",
        exit if exit.is_signal() => "Render cancelled by user\n",
        _ => "Render failed\n",
    }
}
