//! `--warn portable`: text that durer accepts and POV-Ray 3.7 rejects (quirk: `strict_separators`). Where the text
//! alone does not decide what POV-Ray would see, as in a macro's body, nothing is reported.
//!
//! The rules examine the tokens of the scene's own file, with the brackets that are open around each.

mod declared;
mod rules;
mod value;

use super::Names;
use super::ast::Symbol;
use super::class;
use super::lex::{Lexed, lex};
use crate::diagnostic::{Diagnostic, codes};
use crate::source::{FileId, Sources, Span};
use declared::Declared;

/// The label at the place where a `;` is missing.
pub const MISSING_SEMICOLON: &str = "`;` goes here";

/// Reports text of the first file that POV-Ray 3.7 rejects; the other files are its includes.
pub(super) fn lint_portability(sources: &Sources, names: &Names, scene_and_includes: &[FileId]) -> Vec<Diagnostic> {
    let texts: Vec<Text> = scene_and_includes.iter().map(|&file| Text::of(sources, names, file)).collect();
    let Some(own) = texts.first() else { return vec![] };
    let declared = Declared::of(&texts);
    let mut walk = Walk { text: own, declared: &declared, open: vec![], macros: vec![], out: vec![] };
    for at in 0..own.len() {
        walk.step(at);
    }
    walk.out
}

/// Tokens of a file that the portability lint examines.
struct Text<'t> {
    text: &'t str,
    base: usize,
    lexed: Lexed,
}

impl<'t> Text<'t> {
    fn of(sources: &'t Sources, names: &Names, file: FileId) -> Self {
        let (text, base) = (sources.text(file), sources.base(file));
        Self { text, base, lexed: lex(text, base, names, false) }
    }

    fn len(&self) -> usize {
        self.lexed.classes.len()
    }

    /// The class of a token; 0 after the last one.
    fn class(&self, at: usize) -> u8 {
        self.lexed.classes.get(at).copied().unwrap_or(0)
    }

    /// The class of the previous token.
    fn before(&self, at: usize) -> u8 {
        at.checked_sub(1).map_or(0, |at| self.class(at))
    }

    fn word(&self, at: usize) -> &'t str {
        let token = self.lexed.tokens.get(at);
        token.and_then(|t| self.text.get(t.start as usize..t.end as usize)).unwrap_or("")
    }

    fn symbol(&self, at: usize) -> Option<Symbol> {
        let token = self.lexed.tokens.get(at)?;
        (self.class(at) == class::NAME).then_some(Symbol(token.data))
    }

    fn span(&self, at: usize) -> Span {
        let token = self.lexed.tokens.get(at);
        token.map_or(Span::NONE, |t| Span::new(self.base + t.start as usize, self.base + t.end as usize))
    }

    /// True if the token is a word of the scene language.
    fn is_keyword(&self, at: usize) -> bool {
        matches!(self.class(at), class::KEYWORD | class::HEAD | class::FUNCTION)
    }
}

/// An open bracket during the portability lint.
#[derive(Clone, Copy)]
struct Open<'t> {
    /// Class of the open bracket: `BRACE`, `PAREN`, `BRACKET` or `VECTOR`.
    class: u8,
    /// The word before the open bracket.
    word: &'t str,
    /// Index of the open bracket's token.
    at: usize,
    /// True if a directive was found inside of the bracket.
    directed: bool,
    /// True if a word of durer's own was reported in it: one message for each block is enough.
    told: bool,
}

struct Walk<'a> {
    text: &'a Text<'a>,
    declared: &'a Declared,
    open: Vec<Open<'a>>,
    /// The open directives with bodies; those outside of the outermost macro are dropped.
    macros: Vec<u8>,
    out: Vec<Diagnostic>,
}

impl<'a> Walk<'a> {
    fn step(&mut self, at: usize) {
        self.judge(at);
        match self.text.class(at) {
            opener @ (class::BRACE | class::PAREN | class::BRACKET | class::VECTOR) => {
                let word = if at > 0 && self.text.is_keyword(at - 1) { self.text.word(at - 1) } else { "" };
                self.open.push(Open { class: opener, word, at, directed: false, told: false });
            }
            class::BRACE_END | class::PAREN_END | class::BRACKET_END | class::VECTOR_END => drop(self.open.pop()),
            class if is_directive(class) => {
                self.open.iter_mut().for_each(|open| open.directed = true);
                if class == class::MACRO || class::opens_body(class) && !self.macros.is_empty() {
                    self.macros.push(class);
                } else if class == class::END {
                    self.macros.pop();
                }
            }
            _ => {}
        }
    }

    /// The word of the block that directly contains a token.
    fn block(&self) -> Option<&'a str> {
        self.open.last().filter(|open| open.class == class::BRACE).map(|open| open.word)
    }

    fn report(&mut self, at: usize, message: String, help: impl Into<String>) {
        self.out.push(Diagnostic::new(codes::NOT_PORTABLE, self.text.span(at), message).help(help));
    }
}

/// True if a token of this class begins with `#`.
fn is_directive(class: u8) -> bool {
    use class::*;
    matches!(
        class,
        DECLARE | IF | IFDEF | IFNDEF | ELSEIF | ELSE | WHILE | FOR | SWITCH | CASE | RANGE | MACRO | END | PLAIN
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reported(text: &str) -> Vec<String> {
        let (sources, names) = (Sources::default(), Names::default());
        let file = sources.add("a", None, text.into()).unwrap();
        lint_portability(&sources, &names, &[file]).iter().map(|d| sources.snippet(d.span()).to_string()).collect()
    }

    // POV-Ray 3.7 rejects each of these.

    #[test]
    fn commas() {
        for text in [
            "sphere { 0, 1, pigment { rgb 1 } }",
            "sphere { 0, 1, }",
            "union { sphere { 0, 1 }, sphere { 1, 1 } }",
            "sphere { 0, 1 finish { ambient 1, diffuse 1 } }",
            "sphere { 0, 1 pigment { gradient x color_map { [0 rgb 0], [1 rgb 1] } } }",
            "camera { location 0, look_at 1 }",
            "sphere { 0, 1 } , box { 0, 1 }",
            "light_source { 0, rgb 1, shadowless }",
            "mesh { triangle { 0, x, y }, triangle { 0, x, z } }",
            "sphere { 0, 1 pigment { rgb 1, scale 2 } }",
            "sphere { 0, 1 pigment { bozo, color_map { [0 rgb 0] [1 rgb 1] } } }",
            "sphere { 0, 1 texture { pigment { rgb 1 }, finish { ambient 1 } } }",
            "sphere { 0, 1 texture { pigment { rgb 1 } , } }",
            "sphere { 0, 1 normal { bumps 0.5, scale 2 } }",
        ] {
            assert_eq!(reported(text), [","], "{text}");
        }
        for text in [
            "sphere { <0, 0, 0,>, 1 }",
            "#declare A = array[2] { 1, 2, };",
            "mesh2 { vertex_vectors { 3, 0, x, y, } face_indices { 1, <0, 1, 2>, } }",
            "sphere { 0, 1 pigment { checker rgb 1, rgb 0, scale 2 } }",
            "sphere { 0, 1 pigment { checker pigment { rgb 1 }, pigment { rgb 0 } } }",
            "object { M(sphere { 0, 1 }, 2) }",
            "disc { 0, y, 1, }",
            "light_source { 0, rgb 1 area_light x, y, 2, 2 }",
            "#macro M(A, B) A, B #end",
            "sphere { 0, 1 normal { bumps, 0.5 } }",
            "sphere { 0, 1 pigment { Checks(), scale 2 } }",
            "sphere { 0, 1 texture { checker texture { A }, texture { B }, scale 2 } }",
        ] {
            assert_eq!(reported(text), [""; 0], "{text}");
        }
    }

    #[test]
    fn semicolons() {
        assert_eq!(reported("sphere { 0, 1 };"), [";"]);
        for text in [
            "sphere { 0, 1 } #if (0) #end;",
            "#if (1) #declare A = 1; #end; sphere { 0, A }",
            "#for (I, 1, 2) sphere { I*x, 1 } #end;",
            "#declare A = 1; #while (A < 3) #declare A = A + 1; #end;",
            "#macro M() sphere { 0, 1 } #end M();",
            "#macro M() #local A = 1; sphere { 0, A } #end M();",
        ] {
            assert_eq!(reported(text), [";"], "{text}");
        }
        for text in [
            "#declare A = #if (1) 1 #else 2 #end;",
            "#macro M() #local A = 1; #end M();",
            "#macro M() sphere { 0, 1 } #local A = 1; #end M();",
            "#macro M() sphere { 0, 1 } #end #declare A = M();",
            "#macro M() function { x } #end #declare A = M();",
        ] {
            assert_eq!(reported(text), [""; 0], "{text}");
        }
        assert_eq!(reported("sphere { 0, 1 scale 2; }"), [";"]);
        assert_eq!(reported("#include \"colors.inc\"; #declare A = \"a\";"), [";"]);
        assert_eq!(reported("#macro M() #debug \"a\"; #if (1) #end #debug \"b\"; #end #debug \"c\";"), [";"]);
        assert_eq!(reported("sphere { 0, 1 #local R = 2; scale R }"), [""; 0]);
        assert_eq!(reported("#declare S = sphere { 0, 1 };"), [""; 0]);
        for text in ["#if (1) #declare A = 1 #end", "#if (0) #declare A = 1 #else #declare B = 2; #end"] {
            assert_eq!(reported(text), ["A"], "{text}");
        }
        for text in ["#declare A = 1 sphere { 0, A }", "#declare A = 1", "#declare A = <1, 2, 3>*2 box { 0, A }"] {
            assert_eq!(reported(text), ["A"], "{text}");
        }
        for text in [
            "#declare A = 1;",
            "#declare A = M(1) sphere { 0, 1 }",
            "#declare A = \"x\" sphere { 0, 1 }",
            "#declare A = concat(\"a\", \"b\") sphere { 0, 1 }",
            "#version 3.1; #declare A = 1 sphere { 0, A }",
            "#declare A = #if (1) 1; #else 2; #end",
            "#declare A = 1 + // one\n 2;",
            "#declare A[0][1] = -x.y;",
            "#declare A = (1 = 2 ? 3 : 4);",
        ] {
            assert_eq!(reported(text), [""; 0], "{text}");
        }
    }

    #[test]
    fn colors_and_textures() {
        assert_eq!(reported("sphere { 0, 1 pigment { <1, 0, 0> } }"), ["<"]);
        assert_eq!(reported("sphere { 0, 1 pigment { 0.5 } }"), ["0.5"]);
        assert_eq!(reported("#declare C = <1, 0, 0>; #declare M = color_map { [0 C] [1 rgb 0] }"), ["C"]);
        assert_eq!(reported("#declare C = <1, 0, 0>; sphere { 0, 1 pigment { C } }"), ["C"]);
        assert_eq!(reported("#declare C = rgb <1, 0, 0>; sphere { 0, 1 pigment { C } }"), [""; 0]);
        assert_eq!(reported("sphere { 0, 1 pigment { checker <1, 0, 0>, <0, 1, 0> } }"), [""; 0]);
        assert_eq!(reported("#declare T = texture { pigment { rgb 1 } } sphere { 0, 1 T }"), ["T"]);
        assert_eq!(reported("#declare T = texture { pigment { rgb 1 } } sphere { 0, 1 texture { T } }"), [""; 0]);
        assert_eq!(reported("#declare T = transform { scale 2 } sphere { 0, 1 transform T }"), [""; 0]);
        assert_eq!(reported("#declare T = texture { } #declare T = 2; sphere { 0, T }"), [""; 0]);
    }

    #[test]
    fn additions() {
        assert_eq!(reported("camera { eye <0, 0, 5> center 0 }"), ["eye"]);
        assert_eq!(reported("plane { implicit <1, 2, 3, 4> }"), ["implicit"]);
        assert_eq!(reported("#declare point = y; plane { point, 0 }"), [""; 0]);
        assert_eq!(reported("#declare A = array[2, 3];"), [","]);
        assert_eq!(reported("#declare A = array[2][3];"), [""; 0]);
        assert_eq!(reported("#declare A = array { 1, 2 };"), ["array"]);
        assert_eq!(reported("#declare (A, B) = (1, 2);"), ["("]);
    }
}
