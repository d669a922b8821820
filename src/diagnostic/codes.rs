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
    WRONG_TYPE "E0200" "a value of another kind is needed here"
"For example a colour where a number belongs, or a texture where an object belongs."
    NO_DIRECTION "E0300" "a plane has no direction"
"The normal of a plane tells which way it faces, so `plane { <0, 0, 0>, 1 }` is no plane. A plane that is spanned by two
vectors has no normal either if they are parallel. A floor is `plane { y, 0 }`."
    NO_LENGTH "E0301" "a cylinder or cone has no length"
"Its two end points are the same, so nothing tells which way its axis goes: `cylinder { 0, 0, 1 }`. Move one of them, as in
`cylinder { 0, y, 1 }`; a flat round plate is `disc { 0, y, 1 }`."
    FEW_POINTS "E0302" "a polygon has too few points"
"The first number in a `polygon` says how many points follow. It takes three to enclose an area, and the first one is
usually repeated at the end: `polygon { 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }`."
    NOT_FINITE "E0303" "a shape needs finite numbers"
"A number that is infinite, or the outcome of something like 0/0, can't place a shape. Look where the number is computed."
    TWO_FORMS "E0304" "a plane is given twice"
"A plane is given by `normal, distance` or by one of the forms with words, `implicit <A, B, C, D>`, `point q normal n` or
`point q span i, j`, and only once."
    NO_SURFACE "W0300" "a shape has no surface"
"Nothing of it will be seen: a radius is zero or, in a torus, negative; or the normal of a disc is zero; or the hole of a disc
is as large as the disc."
    FLAT_TRIANGLE "W0301" "a triangle has no area"
"Its corners are on one line, or two of them are the same point. It is left out."
    TWISTED_TRIANGLE "W0302" "the normals of a smooth triangle point to both sides"
"All three normals of a `smooth_triangle` must point to the same side of it, and none may lie in its plane. Such a triangle is
left out, as POV-Ray does."
    OPEN_OUTLINE "W0303" "the outline of a polygon is not closed"
"Each outline ends with the point that it began with: `polygon { 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }`. The last one was closed
for you."
    NOT_FLAT "W0304" "the points of a polygon are not in one plane"
"A `polygon` is flat: all its points lie in one plane, to 1e-10, and not all on one line. One that is not is left out, as
POV-Ray does. Split it into triangles."
}

/// The explanation of a code as the user typed it, in any letter case.
pub fn find(code: &str) -> Option<&'static Explanation> {
    ALL.iter().find(|e| e.code.0.eq_ignore_ascii_case(code.trim()))
}
