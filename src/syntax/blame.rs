//! Finds the opener that has no end. In such a text, the last closers have closed the wrong openers: the blocks that
//! can be nested, and the indentation, indicate the right one.

use super::word::{self, SHAPES};
use crate::diagnostic::{Diagnostic, codes};
use crate::source::Span;
use std::ops::Range;

/// Opening brace, or a directive with a body, that may lack its end.
struct Opener<'t> {
    /// The word before the brace, or the directive's word.
    word: &'t str,
    /// Local offset of the brace, or of the `#`.
    at: usize,
    /// Indentation of the opening brace's line, in columns.
    indent: usize,
    /// Start of the opening bracket's line.
    line: usize,
}

/// A token that the scanner returns.
enum Found<'t> {
    /// Opening brace of the form `word {` or `{`: the word, and the offsets of word and brace.
    Open(&'t str, usize, usize),
    Close(usize),
    Directive(&'t str, usize),
}

/// A scanner that skips comments and strings.
struct Scanner<'t> {
    text: &'t str,
    at: usize,
    word: (&'t str, usize),
}

impl<'t> Scanner<'t> {
    fn new(text: &'t str) -> Self {
        Self { text, at: 0, word: ("", 0) }
    }

    fn take_word(&mut self) -> (&'t str, usize) {
        let (start, rest) = (self.at, &self.text[self.at..]);
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
        self.at += end;
        (&rest[..end], start)
    }

    fn skip_past(&mut self, end: &str) {
        let rest = &self.text[self.at..];
        self.at += rest.find(end).map_or(rest.len(), |i| i + end.len());
    }
}

impl<'t> Iterator for Scanner<'t> {
    type Item = Found<'t>;

    fn next(&mut self) -> Option<Found<'t>> {
        loop {
            let rest = &self.text[self.at..];
            let c = rest.chars().next()?;
            let start = self.at;
            match c {
                '/' if rest.starts_with("//") => self.skip_past("\n"),
                '/' if rest.starts_with("/*") => self.skip_past("*/"),
                '"' => {
                    self.at += 1;
                    self.skip_past("\"");
                }
                c if c.is_ascii_alphabetic() || c == '_' => self.word = self.take_word(),
                '#' => {
                    self.at += 1;
                    self.at += self.text[self.at..].len() - self.text[self.at..].trim_start_matches([' ', '\t']).len();
                    let (word, _) = self.take_word();
                    self.word = ("", start);
                    return Some(Found::Directive(word, start));
                }
                '{' => {
                    self.at += 1;
                    let (word, at) = std::mem::replace(&mut self.word, ("", start));
                    return Some(Found::Open(word, if word.is_empty() { start } else { at }, start));
                }
                '}' => {
                    self.at += 1;
                    self.word = ("", start);
                    return Some(Found::Close(start));
                }
                c => {
                    self.at += c.len_utf8();
                    if !c.is_whitespace() {
                        self.word = ("", start);
                    }
                }
            }
        }
    }
}

/// The start of an offset's line, its indentation, and whether the offset is the line's first character that is not
/// blank.
fn line_of(text: &str, at: usize) -> (usize, usize, bool) {
    let start = text[..at].rfind('\n').map_or(0, |i| i + 1);
    let blanks = text[start..].len() - text[start..].trim_start_matches([' ', '\t']).len();
    let columns = text[start..start + blanks].chars().map(|c| if c == '\t' { 8 } else { 1 }).sum();
    (start, columns, start + blanks == at)
}

/// The brace that most probably has no end, if there is an indication.
pub fn open_brace(text: &str, base: usize) -> Option<Diagnostic> {
    let mut stack: Vec<Opener> = vec![];
    let mut blamed = None;
    for found in Scanner::new(text) {
        match found {
            Found::Open(word, word_at, at) => {
                let (line, indent, first) = line_of(text, word_at);
                if let Some(outer) =
                    stack.last().filter(|outer| blamed.is_none() && first && !can_hold(outer.word, word))
                {
                    blamed = Some((outer.word, outer.at, Sign::Inner(word, word_at)));
                }
                stack.push(Opener { word, at, indent, line });
            }
            Found::Close(at) => {
                let (line, indent, first) = line_of(text, at);
                let own = stack.pop();
                if let Some(own) = own.filter(|own| blamed.is_none() && first && own.line < line && indent < own.indent)
                    && let Some(outer) = stack.iter().rev().find(|outer| outer.indent == indent)
                {
                    blamed = Some((own.word, own.at, Sign::Closer(outer.word, at)));
                }
            }
            Found::Directive(..) => {}
        }
    }
    let (word, at, sign) = blamed.filter(|_| !stack.is_empty())?;
    let place = Span::new(base + at, base + at + 1);
    let d = Diagnostic::new(codes::UNCLOSED, place, format!("the `{{` of this `{word}` is not closed"));
    let span = |at: usize, len: usize| Span::new(base + at, base + at + len);
    Some(match sign {
        Sign::Inner(inner, at) => d
            .also(span(at, inner.len()), format!("a `{word}` can't hold a `{inner}`"))
            .help(format!("add `}}` before `{inner}`")),
        Sign::Closer(outer, at) => {
            d.also(span(at, 1), format!("by its indentation, this ends the `{outer}`")).help("add `}` before that line")
        }
    })
}

/// An indication that a block should have ended.
enum Sign<'t> {
    /// A block that the block can't contain.
    Inner(&'t str, usize),
    /// A `}` that by its indentation closes an outer block.
    Closer(&'t str, usize),
}

/// A `}` that ends a block too early, so that a later one closes nothing.
pub fn early_brace(text: &str, base: usize) -> Option<Diagnostic> {
    let (mut stack, mut early): (Vec<Opener>, Option<(usize, &str)>) = (vec![], None);
    // (The contents of a macro or a branch may close brackets that another opens.)
    let mut bodies = 0usize;
    for found in Scanner::new(text) {
        match found {
            Found::Open(word, word_at, at) => {
                let (line, indent, _) = line_of(text, word_at);
                stack.push(Opener { word, at, indent, line });
            }
            Found::Close(at) => {
                let (line, indent, first) = line_of(text, at);
                match (stack.pop(), early) {
                    // The brace is at the end of a line that is deeper than the block's own.
                    _ if bodies > 0 => {}
                    (Some(own), None) if !first && own.line < line && own.indent < indent => {
                        early = Some((at, own.word))
                    }
                    (None, Some((early, word))) => {
                        let span = |at: usize| Span::new(base + at, base + at + 1);
                        let message = format!("this `}}` already ends the `{word}`");
                        let d = Diagnostic::new(codes::UNMATCHED_CLOSER, span(early), message);
                        return Some(d.also(span(at), "so that nothing is left for this one").help("remove it"));
                    }
                    (None, None) => return None,
                    _ => {}
                }
            }
            Found::Directive("end", _) => bodies = bodies.saturating_sub(1),
            Found::Directive(word, _) => bodies += usize::from(BODIES.contains(&word)),
        }
    }
    None
}

/// The directive that most probably has no `#end`, if there is an indication; `outer` is the range of one that is open
/// at the end of the text.
pub(super) fn open_directive(text: &str, base: usize, outer: Range<usize>) -> Option<Diagnostic> {
    let span = |range: Range<usize>| Span::new(base + range.start, base + range.end);
    if let Some((at, word)) = other_end(text, outer.start) {
        let message = format!("there is no directive `#{word}`");
        let d = Diagnostic::new(codes::UNKNOWN_DIRECTIVE, span(at..at + 1 + word.len()), message);
        let open = format!("this `{}` is not closed", &text[outer.clone()]);
        return Some(d.also(span(outer), open).help("every directive with a body ends with `#end`"));
    }
    let (lo, hi) = outdented_directive(text)?;
    let message = format!("this `{}` is not closed", &text[lo..hi]);
    let help = "add `#end` where it should end: by the indentation, the next one belongs further out";
    Some(Diagnostic::new(codes::UNCLOSED, span(lo..hi), message).help(help))
}

/// The directive without `#end`, by the indentation of the others' `#end`.
fn outdented_directive(text: &str) -> Option<(usize, usize)> {
    let mut stack: Vec<Opener> = vec![];
    let mut blamed = None;
    for found in Scanner::new(text) {
        let Found::Directive(word, at) = found else { continue };
        let (line, indent, first) = line_of(text, at);
        match word {
            word if BODIES.contains(&word) => {
                stack.push(Opener { word, at, indent, line });
            }
            "end" => {
                let own = stack.pop();
                if let Some(own) = own.filter(|own| blamed.is_none() && first && own.line < line && indent < own.indent)
                    && stack.iter().any(|outer| outer.indent == indent)
                {
                    blamed = Some((own.at, own.at + 1 + own.word.len()));
                }
            }
            _ => {}
        }
    }
    blamed.filter(|_| !stack.is_empty())
}

/// The first `#endif` or similar word after an offset.
fn other_end(text: &str, from: usize) -> Option<(usize, &str)> {
    let ends = Scanner::new(text).filter_map(|found| match found {
        Found::Directive(word, at) if at > from && super::fault::is_other_end(word) => Some((at, word)),
        _ => None,
    });
    ends.into_iter().next()
}

/// False if a block certainly can't contain another directly.
fn can_hold(outer: &str, inner: &str) -> bool {
    if word::lookup(inner).is_none() {
        return true;
    }
    let whole = matches!(inner, "camera" | "global_settings" | "background" | "sky_sphere" | "rainbow");
    let shape =
        SHAPES.contains(&inner) || matches!(inner, "union" | "difference" | "intersection" | "merge" | "light_source");
    let surface = matches!(inner, "texture" | "finish" | "interior" | "material");
    match outer {
        "pigment" | "normal" => !(whole || shape || surface || inner == "pigment" && outer == "normal"),
        "finish" | "interior" => !(whole || shape || surface || matches!(inner, "pigment" | "normal" | "object")),
        "texture" => !(whole || shape || matches!(inner, "interior" | "material")),
        "camera" | "global_settings" | "light_source" | "background" => {
            !(whole
                || shape
                || surface
                || inner == "object" && outer != "light_source"
                || inner == "pigment" && outer != "camera")
        }
        "union" | "difference" | "intersection" | "merge" | "object" => !whole,
        "blob" | "mesh" => !whole,
        outer if SHAPES.contains(&outer) => !(whole || shape || inner == "object"),
        _ => true,
    }
}

/// Directives that continue to an `#end`.
const BODIES: &[&str] = &["if", "ifdef", "ifndef", "while", "for", "switch", "macro"];

#[cfg(test)]
mod tests {
    use super::*;

    fn blamed(text: &str) -> Option<usize> {
        open_brace(text, 0).map(|d| d.span().lo as usize)
    }

    #[test]
    fn nesting_rules_find_the_open_brace() {
        let text = "sphere {\n  0, 1\n  pigment { rgb 1\n  finish { phong 1 }\n}\n";
        assert_eq!(blamed(text), text.find("{ rgb"));
        assert_eq!(blamed("sphere { 0, 1\n  pigment { rgb 1 }\n"), None);
    }

    #[test]
    fn indentation_finds_the_open_brace() {
        let text = "union {\n  Thing {\n    x\n}\n";
        assert_eq!(blamed(text), text.find("{\n    x"));
        let text = "#if (1)\n  #if (2)\n    #declare A = 1;\n#end\n";
        assert_eq!(outdented_directive(text), Some((10, 13)));
    }

    #[test]
    fn an_early_end_is_found() {
        let text = "sphere {\n  0, 1\n  pigment { rgb 1 } }\n  finish { phong 1 }\n}\n";
        assert_eq!(early_brace(text, 0).map(|d| d.span().lo as usize), text.find("} }").map(|i| i + 2));
    }
}
