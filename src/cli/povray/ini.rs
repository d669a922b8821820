//! The syntax of INI files: splits a text into words of a command line, with their positions (manual, sections 1.5.2
//! and 3.2; quirk: `ini_syntax`).
//!
//! ```text
//! ; the part before the first label is always read
//! Input_File_Name="my scene.pov"   # a setting; the rest of the line after its value is ignored
//! +W320 +H200                      ; any number of switches
//! other.ini[low]                   ; another file, or a section of it
//! [low]                            ; read only on request: `this.ini[Low]`
//! Width=160
//! ```

use crate::diagnostic::{Diagnostic, codes, did_you_mean};
use crate::source::Span;
use std::ops::Range;

/// A word of an INI file: a switch, a setting or a file name, without the quotes around its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// Text of the word as on a command line.
    pub text: String,
    /// Position of the word in the INI file.
    pub span: Span,
    /// Position of the value after `=`; for a word without `=`, of the whole word.
    pub value: Span,
}

/// Contents of an INI file: settings and syntax faults.
#[derive(Debug, Default)]
pub struct Ini {
    /// Settings, switches and file names of the INI file, in the order of the text.
    pub words: Vec<Word>,
    /// Syntax faults of the INI file.
    pub faults: Vec<Diagnostic>,
}

/// Parses an INI file whose first byte has the global offset `base_in_sources`: the part before the first label, and
/// the part `section`.
pub fn parse(text: &str, base_in_sources: usize, section: Option<&str>) -> Ini {
    let mut reader = Reader { text, base_in_sources, out: Ini::default() };
    let mut wanted = true;
    let mut labels = Vec::new();
    let mut found = false;
    for line in line_ranges(text) {
        let line = reader.trimmed(line);
        if !text[line.clone()].starts_with('[') {
            if wanted {
                reader.read_line(line);
            }
            continue;
        }
        let Some(label) = text[line.clone()].find(']').map(|end| text[line.start + 1..line.start + end].trim()) else {
            let d = Diagnostic::new(codes::INI_SYNTAX, reader.span(&line), "expected `]` after the section's name");
            reader.out.faults.push(d);
            continue;
        };
        wanted = section.is_some_and(|section| section.trim().eq_ignore_ascii_case(label));
        found |= wanted;
        labels.push(label);
    }
    if let Some(section) = section.filter(|_| !found) {
        let message =
            format!("there is no section `[{}]`: only the part before the first section is read", section.trim());
        let list: Vec<_> = labels.iter().map(|label| format!("`[{label}]`")).collect();
        let all = (!list.is_empty()).then(|| format!("the file has {}", list.join(", ")));
        let help = did_you_mean(section.trim(), labels.iter().copied()).or(all);
        let start = Span::new(base_in_sources, base_in_sources);
        reader.out.faults.push(Diagnostic::new(codes::INI_SECTION, start, message).maybe_help(help));
    }
    reader.out
}

/// Splits an INI file's argument `file.ini[section]` into file and section.
pub fn split_section(word: &str) -> (&str, Option<&str>) {
    match word.strip_suffix(']').and_then(|word| word.split_once('[')) {
        Some((file, section)) => (file, Some(section)),
        None => (word, None),
    }
}

/// Returns the byte ranges of all lines, which end with CR, LF or CRLF.
fn line_ranges(text: &str) -> impl Iterator<Item = Range<usize>> + '_ {
    let mut start = 0;
    text.split(['\n', '\r']).map(move |line| {
        let range = start..start + line.len();
        start = range.end + 1;
        range
    })
}

struct Reader<'t> {
    text: &'t str,
    base_in_sources: usize,
    out: Ini,
}

impl Reader<'_> {
    fn span(&self, range: &Range<usize>) -> Span {
        Span::new(self.base_in_sources + range.start, self.base_in_sources + range.end)
    }

    fn trimmed(&self, range: Range<usize>) -> Range<usize> {
        let line = &self.text[range.clone()];
        let start = range.start + line.len() - line.trim_start().len();
        start..start + line.trim().len()
    }

    /// Reads words up to the end of the line, a comment, or a setting.
    fn read_line(&mut self, line: Range<usize>) {
        let mut at = line.start;
        loop {
            let rest = &self.text[at..line.end];
            at += rest.len() - rest.trim_start().len();
            let rest = &self.text[at..line.end];
            if rest.is_empty() || rest.starts_with([';', '#']) {
                return;
            }
            let name = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
            if name > 0 && rest[name..].trim_start().starts_with('=') {
                return self.read_setting(at..at + name, line.end);
            }
            let end = self.word_end(at, line.end);
            let range = at..end;
            let word = Word {
                text: remove_all_quotes(&self.text[at..end]),
                span: self.span(&range),
                value: self.span(&range),
            };
            self.out.words.push(word);
            at = end;
        }
    }

    /// Reads an INI line of the form `Name = value`.
    fn read_setting(&mut self, name: Range<usize>, line_end: usize) {
        let after = &self.text[name.end..line_end];
        let equals = name.end + after.find('=').unwrap_or(0) + 1;
        let rest = &self.text[equals..line_end];
        let start = equals + rest.len() - rest.trim_start().len();
        let end = self.word_end(start, line_end);
        let value = &self.text[start..end];
        // `Declare=NAME=VALUE` needs the quotes, which distinguish a text from a number.
        let value = if self.text[name.clone()].eq_ignore_ascii_case("declare") {
            value.into()
        } else {
            remove_all_quotes(value)
        };
        let text = format!("{}={value}", &self.text[name.clone()]);
        self.out.words.push(Word { text, span: self.span(&(name.start..end)), value: self.span(&(start..end)) });
        let rest = self.trimmed(end..line_end);
        if !rest.is_empty() && !self.text[rest.clone()].starts_with([';', '#']) {
            let message = "the rest of the line after the value is ignored";
            let help = "put quotes around a value with spaces, and other options on lines of their own";
            let d = Diagnostic::new(codes::INI_REST, self.span(&rest), message).help(help);
            self.out.faults.push(d);
        }
    }

    /// Returns the end of a word: the next space or comment outside of quotes and brackets.
    fn word_end(&self, start: usize, line_end: usize) -> usize {
        let (mut quote, mut bracket) = (None, false);
        for (i, c) in self.text[start..line_end].char_indices() {
            match (quote, c) {
                (Some(open), _) if c == open => quote = None,
                (Some(_), _) => {}
                (None, '"' | '\'') => quote = Some(c),
                (None, '[') => bracket = true,
                (None, ']') => bracket = false,
                (None, _) if !bracket && (c.is_whitespace() || c == ';' || c == '#') => return start + i,
                _ => {}
            }
        }
        line_end
    }
}

/// Removes all quotes from a POV-Ray option, also those in the middle: `+I"my scene.pov"` becomes `+Imy scene.pov`.
/// Quotes of the other kind inside a quotation stay.
fn remove_all_quotes(word: &str) -> String {
    let mut quote = None;
    let mut out = String::new();
    for c in word.chars() {
        match (quote, c) {
            (Some(open), _) if c == open => quote = None,
            (None, '"' | '\'') => quote = Some(c),
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str, section: Option<&str>) -> Vec<String> {
        let ini = parse(text, 1, section);
        assert_eq!(ini.faults, []);
        ini.words.into_iter().map(|word| word.text).collect()
    }

    #[test]
    fn settings_switches_files_and_comments() {
        let text = "; a\n# b\nWidth = 3 ; c\r\n  Height=2#d\r+W4  -D ;e\n\nother.ini[Really Low]\nEmpty=\n";
        assert_eq!(words(text, None), ["Width=3", "Height=2", "+W4", "-D", "other.ini[Really Low]", "Empty="]);
        assert_eq!(words("+kf0.16 +kff20 +kc declare=fp=0", None), ["+kf0.16", "+kff20", "+kc", "declare=fp=0"]);
    }

    #[test]
    fn quotes_keep_spaces_in_a_word() {
        let text = "Input_File_Name=\"my #1 scene.pov\"\n+I'it''s.pov'\nDeclare=A=\"x y\"";
        assert_eq!(words(text, None), ["Input_File_Name=my #1 scene.pov", "+Iits.pov", "Declare=A=\"x y\""]);
    }

    #[test]
    fn sections_are_read_on_request() {
        let text = "A=1\n[Low]\nA=2\n [ Really High ] ; x\nA=3\n";
        assert_eq!(words(text, None), ["A=1"]);
        assert_eq!(words(text, Some("low")), ["A=1", "A=2"]);
        assert_eq!(words(text, Some("really high")), ["A=1", "A=3"]);
        let faults = parse(text, 1, Some("lwo")).faults;
        assert_eq!(faults[0].help.as_deref(), Some("did you mean `Low`?"));
        assert_eq!(split_section("a.ini[Low]"), ("a.ini", Some("Low")));
        assert_eq!(split_section("a.ini"), ("a.ini", None));
    }

    #[test]
    fn words_have_their_positions() {
        let ini = parse("; x\nWidth = abc ; y", 11, None);
        assert_eq!((ini.words[0].span, ini.words[0].value), (Span::new(15, 26), Span::new(23, 26)));
    }

    #[test]
    fn ignored_text_is_reported() {
        let codes = |text: &str| parse(text, 1, None).faults.iter().map(|d| d.code.0).collect::<Vec<_>>();
        assert_eq!(codes("Width=3 Height=4"), ["W0014"]);
        assert_eq!(codes("[low"), ["E0015"]);
        assert_eq!(codes("=\n]\n\u{e9}=\"x\n"), [""; 0]);
    }
}
