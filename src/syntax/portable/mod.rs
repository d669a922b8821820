//! The lint `--warn portable`: text that durer accepts and POV-Ray 3.7 rejects (quirk: `strict_separators`). Nothing is
//! reported where the text alone does not decide how POV-Ray reads it, as in a macro's body.
//!
//! The rules examine the tokens of the scene's own file, with the brackets that are open around each token.

mod declared;
mod rules;
mod value;

use super::class;
use super::outline::{Outline, Pair};
use crate::diagnostic::{Diagnostic, codes};
use declared::Declared;

/// Label of the position where a `;` is missing.
pub const MISSING_SEMICOLON: &str = "`;` goes here";

/// Reports text of the scene's own file that POV-Ray 3.7 rejects. In the outline `own_file`, each number is a token;
/// `all_files` holds the outlines of the file and of its includes.
pub(super) fn lint_portability(own_file: &Outline, all_files: &[Outline]) -> Vec<Diagnostic> {
    let declared = Declared::new(own_file, all_files);
    let mut check = Check { outline: own_file, declared: &declared, directive: None, addition: None, out: vec![] };
    for token in 0..own_file.tokens.len() {
        check.apply_rules(token);
        if class::is_directive(own_file.class(token)) {
            check.directive = Some(token);
        }
    }
    check.out
}

/// Portability lint of a scene's own file, at one of its tokens.
struct Check<'a> {
    outline: &'a Outline,
    declared: &'a Declared<'a>,
    /// Index of the last directive before the present token; `None` before the first directive.
    directive: Option<usize>,
    /// Index of the last token that was reported as a word that only durer has; `None` before the first report.
    addition: Option<usize>,
    out: Vec<Diagnostic>,
}

impl<'a> Check<'a> {
    /// Returns the brackets around a token, the innermost first.
    fn brackets_around(&self, token: usize) -> impl Iterator<Item = &'a Pair> + use<'a> {
        self.outline.pairs_around(token).filter(|pair| pair.bracket != b'#' && pair.closer.is_some())
    }

    /// Returns the directives whose bodies contain a token, the innermost first.
    fn directives_around(&self, token: usize) -> impl Iterator<Item = &'a Pair> + use<'a> {
        self.outline.pairs_around(token).filter(|pair| pair.bracket == b'#')
    }

    fn in_macro(&self, token: usize) -> bool {
        self.directives_around(token).any(|pair| self.outline.is_macro(pair))
    }

    /// Returns the word of the block that directly contains a token; `None` outside of all blocks, and in other
    /// brackets.
    fn enclosing_block_word(&self, token: usize) -> Option<&'a str> {
        self.brackets_around(token).next().filter(|pair| pair.bracket == b'{').map(|pair| self.outline.head(pair))
    }

    fn report(&mut self, token: usize, message: String, help: impl Into<String>) {
        self.out.push(Diagnostic::new(codes::NOT_PORTABLE, self.outline.token_span(token), message).help(help));
    }
}

/// True if the token is a word of the scene language.
fn is_keyword(outline: &Outline, token: usize) -> bool {
    matches!(outline.class(token), class::KEYWORD | class::HEAD | class::FUNCTION)
}

/// Returns the index of the token after the partner of an opening bracket; `None` if a directive is between them.
fn token_after_partner(outline: &Outline, open: usize) -> Option<usize> {
    let closer = outline.opened_by(open)?.closer?;
    (open..closer).all(|token| !class::is_directive(outline.class(token))).then_some(closer + 1)
}

#[cfg(test)]
mod tests {
    use crate::source::Sources;
    use crate::syntax::lint::{Lints, lint_scene};

    fn reported(text: &str) -> Vec<String> {
        let sources = Sources::default();
        let file = sources.add("a", None, text.into()).unwrap();
        let lints = Lints { portable: true, ..Lints::default() };
        lint_scene(&sources, &[file], lints).iter().map(|d| sources.snippet(d.span()).to_string()).collect()
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
