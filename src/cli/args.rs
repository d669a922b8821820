//! The options of the command line. Every option that is taken is obeyed.

use super::animation::Animation;
use super::values::{Antialias, Bytes, Clock, Declare, Frames, Part, Pixel, Seconds, Size, Stats, Version};
use crate::image_io::Format;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

const EXIT_CODES: &str = "\
Exit codes: 0 fine, 1 the scene is wrong, 2 the command line is wrong, 3 a snapshot differs, 4 a limit was reached, \
5 a file could not be read or written.

`durer scene.pov` and POV-Ray's own options work too: durer +Iscene.pov +W640 +H480 +A0.3";

/// Draws scenes written by hand in POV-Ray's scene language.
#[derive(Parser, Clone, Debug)]
#[command(name = "durer", version, after_help = EXIT_CODES, arg_required_else_help = true, max_term_width = 100)]
pub struct Cli {
    #[command(flatten)]
    #[allow(missing_docs)]
    pub common: Common,
    #[command(subcommand)]
    #[allow(missing_docs)]
    pub command: Command,
}

/// What every command takes.
#[derive(Args, Clone, Copy, Debug)]
pub struct Common {
    /// Say nothing but errors
    #[arg(short, long, global = true)]
    pub quiet: bool,
    /// Messages in colour
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto", hide_possible_values = false)]
    pub color: When,
}

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

/// The commands.
#[derive(Subcommand, Clone, Debug)]
pub enum Command {
    /// Draw a scene into a picture file
    Render(Box<RenderArgs>),
    /// Read and evaluate scenes, draw nothing
    Check(CheckArgs),
    /// Tell what is seen through one pixel
    Pick(PickArgs),
    /// Draw each scene that has a snapshot beside it, and compare
    Test(TestArgs),
    /// Explain the code of a message, such as E0001
    Explain(ExplainArgs),
    /// Print a script that completes durer's options in your shell
    Completions(CompletionsArgs),
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

/// What a scene is given when it is read.
#[derive(Args, Clone, Debug, Default)]
pub struct SceneArgs {
    /// Look for included files here too
    #[arg(short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
    /// Whose include files: an installed POV-Ray's before those built in, or the built-in ones alone
    #[arg(long, value_name = "WHOSE", default_value = "installed", hide_possible_values = false)]
    pub library: Library,
    /// Let the scene read files below this folder too
    #[arg(long, value_name = "DIR")]
    pub allow_read: Vec<PathBuf>,
    /// Let the scene write files below this folder too
    #[arg(long, value_name = "DIR")]
    pub allow_write: Vec<PathBuf>,
    /// Declare an identifier: a number, or text in quotes
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub declare: Vec<Declare>,
    /// The version of the language, such as 3.1, until the scene's own `#version`
    #[arg(long, value_name = "VERSION")]
    pub language: Option<Version>,
    /// Width and height in pixels [default: 640x480]
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// The frame of an animation
    #[arg(long, value_name = "N")]
    pub frame: Option<u32>,
    /// Of an INI file, or of POV-Ray's options.
    #[arg(skip)]
    pub animation: Option<Animation>,
    /// The value of `clock`; A..B for the first and last of many frames [default: 0..1]
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub clock: Option<Clock>,
    /// Take the text apart into single tokens: slow, and for tests, since what comes out is the same
    #[arg(long, hide = true)]
    pub single_tokens: bool,
    /// End with exit code 4 after so many statements
    #[arg(long, value_name = "N", default_value_t = DEFAULT_STEPS)]
    pub max_steps: u64,
    /// End with exit code 4 when so much memory is needed, such as 2G [default: most of what is free]
    #[arg(long, value_name = "BYTES")]
    pub max_memory: Option<Bytes>,
    /// End with exit code 4 after so many seconds
    #[arg(long, value_name = "SECONDS")]
    pub max_time: Option<Seconds>,
}

/// Ends an endless loop within some ten seconds.
pub const DEFAULT_STEPS: u64 = 200_000_000;

/// How a picture is drawn.
#[derive(Args, Clone, Debug, Default)]
pub struct LookArgs {
    /// Threshold of anti-aliasing, or `off` [default: 0.3]
    #[arg(long, value_name = "THRESHOLD")]
    pub aa: Option<Antialias>,
    /// From 0 (quick colours) to 11 (everything) [default: 9]
    #[arg(long, value_name = "0..11", value_parser = clap::value_parser!(u8).range(0..=11))]
    pub quality: Option<u8>,
    /// Leave the background transparent
    #[arg(long)]
    pub alpha: bool,
}

/// `durer render`.
#[derive(Args, Clone, Debug, Default)]
pub struct RenderArgs {
    /// The scene, an INI file, or - for standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// The picture's file, or - for standard output [default: the input's name with .png, here]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// A single frame of an INI file goes to a file of this very name.
    #[arg(skip)]
    pub exact_name: bool,
    /// The picture's format [default: by the output's ending; png for standard output]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser())]
    pub format: Option<String>,
    /// Bits for each channel: 8 or 16 [default: 8]
    #[arg(long, value_name = "8|16", value_parser = clap::builder::PossibleValuesParser::new(["8", "16"]))]
    pub bit_depth: Option<String>,
    /// Draw, but write no picture
    #[arg(long, conflicts_with_all = ["output", "format", "bit_depth"])]
    pub no_output: bool,
    /// Warn of more: `options` of POV-Ray that mean nothing here, such as +D
    #[arg(long, value_name = "WHAT", value_delimiter = ',')]
    pub warn: Vec<DrawingWarn>,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub look: LookArgs,
    /// Draw many frames [default: those of the INI file]; the names get as many digits as B is written with
    #[arg(long, value_name = "A-B[:STEP]", conflicts_with = "frame")]
    pub frames: Option<Frames>,
    /// Draw only this part of the picture
    #[arg(long, value_name = "X,Y,W,H")]
    pub region: Option<Part>,
    /// How many threads draw [default: one for each processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
    /// Show how far the picture is [default: auto]
    #[arg(long, value_name = "WHEN")]
    pub progress: Option<When>,
    /// Times, rays and memory as JSON: `json` for standard output, or a file
    #[arg(long, value_name = "json|FILE")]
    pub stats: Option<Stats>,
    /// Print what was understood as JSON, and draw nothing
    #[arg(long, value_name = "STAGE")]
    pub dump: Option<Dump>,
}

fn format_parser() -> clap::builder::PossibleValuesParser {
    clap::builder::PossibleValuesParser::new(Format::names())
}

/// What `--dump` prints.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dump {
    /// What the author said
    Scene,
    /// What a ray needs
    World,
}

/// `durer check`.
#[derive(Args, Clone, Debug)]
pub struct CheckArgs {
    /// Scenes, INI files, or - for standard input
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
    /// For a person, or one JSON object a line on standard output
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: MessageFormat,
    /// Let `warnings` fail as errors do
    #[arg(long, value_name = "WHAT")]
    pub deny: Option<Deny>,
    /// Warn of more: names that are declared and `unused`, names that `shadow` others, `options` in an INI file that mean nothing, what
    /// is not `portable` to POV-Ray 3.7, what is `doubtful`
    #[arg(long, value_name = "WHAT", value_delimiter = ',')]
    pub warn: Vec<Warn>,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
}

/// How messages are written.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageFormat {
    /// For a person
    Human,
    /// code, severity, message, file, line, column, end, help, labels, trace
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

/// `durer pick`.
#[derive(Args, Clone, Debug)]
pub struct PickArgs {
    /// The scene, or - for standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Column and row, counted from 0 at the top left
    #[arg(value_name = "X,Y", allow_hyphen_values = true)]
    pub pixel: Pixel,
    /// As one JSON object
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
}

/// `durer test`.
#[derive(Args, Clone, Debug)]
#[command(after_help = "A snapshot is a PNG beside the scene, of the same name. A scene may say how its snapshot is \
                        drawn, in a comment at its start:\n\n    //! test: --size 128x96 --aa off")]
pub struct TestArgs {
    /// Scenes and folders [default: the current folder]
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Take what is drawn now as the snapshot; makes new ones for scenes that are named
    #[arg(long)]
    pub accept: bool,
    /// Write a page with the pictures side by side
    #[arg(long, value_name = "DIR")]
    pub report: Option<PathBuf>,
    /// Look for included files here too
    #[arg(short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
    /// How many threads draw [default: one for each processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
}

/// `durer explain`.
#[derive(Args, Clone, Debug)]
pub struct ExplainArgs {
    /// The code; all are listed without one
    #[arg(value_name = "CODE")]
    pub code: Option<String>,
}

/// `durer completions`.
#[derive(Args, Clone, Debug)]
pub struct CompletionsArgs {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

impl SceneArgs {
    /// Width and height.
    pub fn size(&self) -> Size {
        self.size.unwrap_or_default()
    }
}
