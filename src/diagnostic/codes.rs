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
"A scene is a text file. This one holds bytes that no text holds, as pictures, archives and programs do.
Text in UTF-16, as some editors write it, has to be saved as UTF-8."
    FILE_NOT_FOUND "E0002" "there is no such file"
"No file of this name is there. Names are looked up in the current folder unless they start with `/`; upper and lower
case letters differ on most systems. `-` stands for standard input."
    FILE_UNREADABLE "E0003" "the file can't be read"
"It is there, but it is a folder, or larger than 4 GB, or the system doesn't let you read it."
    FILE_UNWRITABLE "E0004" "the file can't be written"
"Its folder doesn't exist, or you may not write there, or the disk is full. A picture is written whole or not at all: first
into a temporary file in the same folder, which then takes the name. So the folder itself has to be writable. Nothing was
changed."
    UNKNOWN_FORMAT "E0005" "the file's ending names no picture format"
"The ending of the output's name says in which format the picture is written: png, exr, hdr, jpg, ppm, bmp, tga or tiff.
`--format` says it for names without such an ending, and for standard output:

    durer render ball.scene -o - --format ppm | display"
    PICTURE_TOO_LARGE "E0006" "the picture needs more memory than there is"
"A picture takes 16 bytes for each pixel while it is drawn, and about as much again while it is written. `--max-memory` sets
a limit of your own; without it, what the machine has free is the limit. `--size` makes the picture smaller."
    PICTURE_BROKEN "E0007" "the picture file can't be decoded"
"It is damaged, cut off, or of another kind than its name says."
    FORMAT_LIMIT "E0008" "the picture format can't hold this picture"
"Every format has limits: jpg holds 65535 pixels a side, bmp, tga and jpg hold 8 bits a channel, exr and hdr always hold
floating-point numbers, and only png, tiff, bmp, tga and exr know transparency. Choose another format, for example png."
    TIME_LIMIT "E0009" "the time that `--max-time` allows is over"
"The picture was not finished in the time that `--max-time SECONDS` allows, so nothing was written."
    OUTSIDE_PICTURE "E0010" "this part is not inside the picture"
"Pixels are counted from the top left, starting with 0: a picture of 640x480 goes from 0,0 to 639,479. `--size` says how large
the picture is."
    UNKNOWN_OPTION "E0011" "there is no such option"
"durer takes its own options (`durer render --help`) and those of POV-Ray (`+W640`, `Width=640`). This is neither."
    OPTION_IGNORED "W0012" "a POV-Ray option that has no effect here"
"POV-Ray has this option and durer knows it, but doesn't do what it asks for. The picture is drawn without it."
    SYNTAX "E0100" "something stands where nothing of the kind can stand"
"The text can't be read as a scene from this place on."
    WRONG_TYPE "E0200" "a value of another kind is needed here"
"For example a colour where a number belongs, or a texture where an object belongs."
}

/// The explanation of a code as the user typed it, in any letter case.
pub fn find(code: &str) -> Option<&'static Explanation> {
    ALL.iter().find(|e| e.code.0.eq_ignore_ascii_case(code.trim()))
}
