//! Options that take one of a few words.

use clap::ValueEnum;

/// `auto` is on a terminal only.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// On a terminal
    Auto,
    /// Everywhere
    Always,
    /// Nowhere
    Never,
}

/// Where the samples of anti-aliasing lie.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum AaMethod {
    /// 4 beside the middle, and 5 more where those differ, as evenly as possible
    Net,
    /// In the cells of a grid: POV-Ray's first method
    Grid,
    /// Between corners, again and again: POV-Ray's second method
    Corners,
}

/// How numbers are rounded.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum DitherMethod {
    /// By a pattern of 2 x 2 pixels
    B2,
    /// By a pattern of 3 x 3 pixels
    B3,
    /// By a pattern of 4 x 4 pixels
    B4,
    /// The error goes to the next pixel
    D1,
    /// The error goes to the next pixel and to two below
    D2,
    /// The error goes to the next pixel and to three below (Floyd and Steinberg)
    Fs,
}

/// How exr is packed.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExrPacking {
    /// Not at all
    None,
    /// Run lengths: fast
    Rle,
    /// Deflate: small
    Zip,
}

/// Where standard include files come from.
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Library {
    /// An installed POV-Ray's, if there is one, then the built-in ones
    #[default]
    Installed,
    /// The built-in ones
    Durer,
}

/// What `--dump` prints.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dump {
    /// What the author said
    Scene,
    /// What a ray needs
    World,
}

/// How results are written.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageFormat {
    /// For a person
    Human,
    /// One object a line
    Json,
}

/// How messages are written.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum CheckFormat {
    /// For a person
    Human,
    /// file:line:column: error[CODE]: message, one a line
    Short,
    /// One object a line: code, severity, message, file, line, column, end, help, labels, trace
    Json,
}

/// What `--deny` makes an error of.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deny {
    /// All warnings
    Warnings,
}

/// What `--warn` adds.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Warn {
    /// Names that are declared and never used
    Unused,
    /// Names in macros that hide others
    Shadow,
    /// Options of POV-Ray that mean nothing here
    Options,
    /// What POV-Ray 3.7 would refuse
    Portable,
    /// What is mostly meant as it is said, but not always
    Doubtful,
}

/// What `--warn` adds where a picture is drawn.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawingWarn {
    /// Options of POV-Ray that mean nothing here
    Options,
}
