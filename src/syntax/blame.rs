//! Finds the opening bracket whose closing bracket is missing, by which blocks may contain which others and by the
//! indentation. The last opening bracket without a partner is rarely the culprit, since later closing brackets are
//! matched with the wrong ones.

use super::fault::is_other_end;
use super::outline::{Line, Outline, Pair};
use super::word::{self, SHAPES};
use crate::diagnostic::{Diagnostic, codes};

/// Returns all opening and closing braces in order: token index, line and, for an opening brace, its pair. The line of
/// an opening brace is the line of the word before the brace.
fn braces_lines_and_pairs(outline: &Outline) -> impl Iterator<Item = (usize, Line, Option<&Pair>)> {
    let is_brace = |&token: &usize| matches!(outline.token_text(token), "{" | "}");
    (0..outline.tokens.len()).filter(is_brace).map(|token| {
        let opened = outline.opened_by(token);
        let start = opened.map_or(outline.tokens[token].range.start, |pair| pair.head.start);
        (token, outline.line_at(start), opened)
    })
}

/// True if `closer` is on a later line with less indentation than `opener`, and probably closes an outer pair.
fn is_outdented(closer: &Line, opener: &Line) -> bool {
    closer.is_first && opener.start < closer.start && closer.indent < opener.indent
}

/// Evidence that a block should have ended earlier.
enum Evidence<'o> {
    /// A nested block that the outer block can't contain.
    Inner(&'o Pair),
    /// The token index of a `}` whose indentation matches an outer block.
    Closer(&'o Pair, usize),
}

/// Returns the error for the opening brace that most probably lacks its `}`; `None` without evidence, or if no brace is
/// open at the end of the text.
pub fn unclosed_brace_error(outline: &Outline) -> Option<Diagnostic> {
    // Match each `}` with the last `{`, also across the bodies of directives.
    let mut stack: Vec<(&Pair, Line)> = vec![];
    let mut blamed = None;
    for (token, line, opened) in braces_lines_and_pairs(outline) {
        if let Some(inner) = opened {
            let outer = stack.last().map(|(outer, _)| *outer).filter(|_| blamed.is_none() && line.is_first);
            if let Some(outer) = outer.filter(|outer| !can_block_contain(outline.head(outer), outline.head(inner))) {
                blamed = Some((outer, Evidence::Inner(inner)));
            }
            stack.push((inner, line));
        } else if let Some((own, begin)) = stack.pop()
            && blamed.is_none()
            && is_outdented(&line, &begin)
            && let Some((outer, _)) = stack.iter().rev().find(|(_, outer)| outer.indent == line.indent)
        {
            blamed = Some((own, Evidence::Closer(outer, token)));
        }
    }
    let (own, evidence) = blamed.filter(|_| !stack.is_empty())?;
    let word = outline.head(own);
    let message = format!("the `{{` of this `{word}` is not closed");
    let d = Diagnostic::new(codes::UNCLOSED, outline.token_span(own.opener), message);
    Some(match evidence {
        Evidence::Inner(inner) => {
            let name = outline.head(inner);
            d.also(outline.span(&inner.head), format!("a `{word}` can't hold a `{name}`"))
                .help(format!("add `}}` before `{name}`"))
        }
        Evidence::Closer(outer, closer) => {
            let ends = format!("by its indentation, this ends the `{}`", outline.head(outer));
            d.also(outline.token_span(closer), ends).help("add `}` before that line")
        }
    })
}

/// Returns the error for a `}` that ends a block too early, so that a later `}` closes nothing.
pub fn early_brace_error(outline: &Outline) -> Option<Diagnostic> {
    let (mut stack, mut early): (Vec<(&Pair, Line)>, _) = (vec![], None);
    for (closer, line, opened) in braces_lines_and_pairs(outline) {
        if let Some(pair) = opened {
            stack.push((pair, line));
            continue;
        }
        match (stack.pop(), early) {
            // The contents of a macro or a branch may close brackets that another opens.
            _ if outline.pairs_around(closer).any(|pair| pair.bracket == b'#') => {}
            // The brace is at the end of a line that is deeper than the block's own.
            (Some((own, begin)), None) if !line.is_first && begin.start < line.start && begin.indent < line.indent => {
                early = Some((closer, own));
            }
            (None, Some((early, own))) => {
                let message = format!("this `}}` already ends the `{}`", outline.head(own));
                let d = Diagnostic::new(codes::UNMATCHED_CLOSER, outline.token_span(early), message);
                let surplus = outline.token_span(closer);
                return Some(d.also(surplus, "so that nothing is left for this one").help("remove it"));
            }
            (None, None) => return None,
            _ => {}
        }
    }
    None
}

/// Returns the errors for directives without `#end`: the directive that most probably lacks its `#end`, or without
/// evidence the innermost three.
pub(super) fn unclosed_directive_errors(outline: &Outline) -> Vec<Diagnostic> {
    let open: Vec<_> = directives_with_body(outline).filter(|pair| pair.closer.is_none()).collect();
    let Some(outermost) = open.first() else { return vec![] };
    if let Some(d) = endif_like_word_error(outline, outermost).or_else(|| outdented_end_error(outline)) {
        return vec![d];
    }
    let unclosed = |pair: &&Pair| unclosed_directive_error(outline, pair).help("add `#end` where it should end");
    open.iter().rev().take(3).map(unclosed).collect()
}

/// Returns the directives of a text that need an `#end`.
fn directives_with_body(outline: &Outline) -> impl Iterator<Item = &Pair> {
    outline.pairs.iter().filter(|pair| pair.bracket == b'#')
}

fn unclosed_directive_error(outline: &Outline, pair: &Pair) -> Diagnostic {
    let message = format!("this `{}` is not closed", outline.token_text(pair.opener));
    Diagnostic::new(codes::UNCLOSED, outline.token_span(pair.opener), message)
}

/// Returns the error for the first `#endif` or similar word after an open directive.
fn endif_like_word_error(outline: &Outline, open: &Pair) -> Option<Diagnostic> {
    let end = outline.tokens[open.opener..].iter().find(|token| is_other_end(outline.directive_word(token)))?;
    let message = format!("there is no directive `#{}`", outline.directive_word(end));
    let d = Diagnostic::new(codes::UNKNOWN_DIRECTIVE, outline.span(&end.range), message);
    let unclosed = format!("this `{}` is not closed", outline.token_text(open.opener));
    Some(d.also(outline.token_span(open.opener), unclosed).help("every directive with a body ends with `#end`"))
}

/// Returns the error for an inner directive whose `#end` is indented like an outer directive's.
fn outdented_end_error(outline: &Outline) -> Option<Diagnostic> {
    let line = |token: usize| outline.line_at(outline.tokens[token].range.start);
    let is_wrong = |pair: &&Pair| {
        let Some(end) = pair.closer.map(line).filter(|end| is_outdented(end, &line(pair.opener))) else { return false };
        let mut outer = outline.pairs_around(pair.opener).filter(|outer| outer.bracket == b'#');
        outer.any(|outer| line(outer.opener).indent == end.indent)
    };
    let wrong = directives_with_body(outline).filter(is_wrong).min_by_key(|pair| pair.closer)?;
    let help = "add `#end` where it should end: by the indentation, the next one belongs further out";
    Some(unclosed_directive_error(outline, wrong).help(help))
}

/// False if a block of the name `outer` certainly can't contain a block of the name `inner` directly.
fn can_block_contain(outer: &str, inner: &str) -> bool {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::tokens_of;

    fn outline(text: &str) -> Outline {
        Outline::new(text, &tokens_of(text, 0).0)
    }

    fn blamed(text: &str) -> Option<usize> {
        unclosed_brace_error(&outline(text)).map(|d| d.span().lo as usize)
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
        assert_eq!(outdented_end_error(&outline(text)).map(|d| (d.span().lo, d.span().hi)), Some((10, 13)));
    }

    #[test]
    fn an_early_end_is_found() {
        let text = "sphere {\n  0, 1\n  pigment { rgb 1 } }\n  finish { phong 1 }\n}\n";
        assert_eq!(early_brace_error(&outline(text)).map(|d| d.span().lo as usize), text.find("} }").map(|i| i + 2));
    }
}
