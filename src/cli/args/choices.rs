//! Values of command-line options that are one of a few words.

use clap::ValueEnum;

/// When a feature of the terminal is used.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// On a terminal only
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

/// Value of `--progress`: the display of a render's progress.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProgressDisplay {
    /// A bar on a terminal; for a shard elsewhere, lines
    Auto,
    /// A bar on a terminal, elsewhere a line every 5 % or 30 seconds
    Always,
    /// Nothing
    Never,
    /// A JSON object a line on standard error
    Json,
    /// Lines for Open Job Description on standard error
    Openjd,
}

/// Sample layout of anti-aliasing.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum AaMethod {
    /// 5 samples on a lattice for a pixel that differs from a neighbour, and 10 if these differ much
    Net,
    /// Cells of a grid: POV-Ray's first method
    Grid,
    /// Recursive subdivision between corners: POV-Ray's second method
    Corners,
}

/// Dithering method.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum DitherMethod {
    /// 2 x 2 Bayer pattern
    B2,
    /// 3 x 3 Bayer pattern
    B3,
    /// 4 x 4 Bayer pattern
    B4,
    /// Error diffusion to the next pixel
    D1,
    /// Error diffusion to the next pixel and two below
    D2,
    /// Error diffusion to the next pixel and three below (Floyd and Steinberg)
    Fs,
}

/// Pixels outside of the region that is rendered.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// Transparent, where the format can hold transparency
    Transparent,
    /// Black and opaque
    Black,
}

/// Compression of exr and tga.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum PackingMethod {
    /// Uncompressed
    None,
    /// Run lengths: fast
    Rle,
    /// Deflate: small, for exr alone
    Zip,
}

/// Source of the standard include files.
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Library {
    /// Those of an installed POV-Ray, then the built-in ones
    #[default]
    Installed,
    /// The built-in ones only
    Durer,
}

/// Value of `--dump`: the stage that is printed.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dump {
    /// The scene after its script has run, in the author's terms
    Scene,
    /// The lowered scene, as the renderer traces rays through it
    World,
}

/// Format of the results of `durer test`.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageFormat {
    /// For people
    Human,
    /// One object a line
    Json,
}

/// Format of the messages of `durer check`.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum CheckFormat {
    /// For people
    Human,
    /// file:line:column: error[CODE]: message, one a line
    Short,
    /// One object a line: code, severity, message, file, line, column, end, help, labels, trace
    Json,
}

/// Value of `--deny`: the class of messages that become errors.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deny {
    /// All warnings
    Warnings,
}

/// Value of `--warn` of `durer check`: a class of warnings that is enabled.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Warn {
    /// Identifiers that are declared and never used
    Unused,
    /// Identifiers in macros that hide others
    Shadow,
    /// Options of POV-Ray without effect in durer
    Options,
    /// Text that POV-Ray 3.7 would refuse
    Portable,
    /// Text that is often, but not always, a mistake
    Doubtful,
}

/// Value of `--warn` of `durer render`: a class of warnings that is enabled.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawingWarn {
    /// Options of POV-Ray without effect in durer
    Options,
}
