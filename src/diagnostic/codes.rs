//! Every code there is. A code is never reused or renumbered; each has a case in `tests/ui`.

use super::Severity;

/// A stable code such as `E0102`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Code(pub &'static str);

impl Code {
    /// `W…` warns, `E…` is an error.
    pub fn severity(self) -> Severity {
        if self.0.starts_with('W') { Severity::Warning } else { Severity::Error }
    }
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.0)
    }
}

/// What `durer explain` prints.
pub struct Explanation {
    /// The code.
    pub code: Code,
    /// One line.
    pub title: &'static str,
    /// A paragraph or two, with an example.
    pub text: &'static str,
}

macro_rules! codes {
    ($($name:ident $code:literal $title:literal $text:literal)*) => {
        $(#[doc = $title] pub const $name: Code = Code($code);)*
        /// All of them, in the order of their numbers.
        pub const ALL: &[Explanation] = &[$(Explanation { code: $name, title: $title, text: $text }),*];
    };
}

codes! {
    NOT_TEXT "E0001" "the file is not text"
"A scene is a text file. This one holds bytes that no text holds, as pictures, archives and programs do."
    SYNTAX "E0100" "something stands where nothing of the kind can stand"
"The text can't be read as a scene from this place on."
    UNCLOSED "E0101" "something is opened and never closed"
"A `{`, `(`, `[`, string, comment or directive has no end. The message stands at the opener, since the text gives no
sign of where the end was meant to be.\n\n    sphere { <0, 0, 0>, 1\n    // the `}` is missing"
    UNMATCHED_CLOSER "E0102" "something is closed that was never opened"
"A `}`, `)`, `]` or `#end` has no opener. Often one too many was typed, or the opener was deleted."
    UNKNOWN_DIRECTIVE "E0103" "no directive of this name"
"A directive is a `#` and a word: #declare, #local, #if, #while, #for, #macro, #include and so on.\n\n    #declre A = 1;   // #declare"
    TOO_DEEP "E0104" "brackets are nested too deeply"
"A thousand brackets, directives or choices inside each other are more than any scene needs: the file is probably damaged."
    WRONG_TYPE "E0200" "a value of another kind is needed here"
"For example a colour where a number belongs, or a texture where an object belongs."
}

/// The explanation of a code as the user typed it, in any letter case.
pub fn find(code: &str) -> Option<&'static Explanation> {
    ALL.iter().find(|e| e.code.0.eq_ignore_ascii_case(code.trim()))
}
