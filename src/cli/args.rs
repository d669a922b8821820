//! The options of the command line. Every option that is taken is obeyed.

use super::animation::Animation;
pub use super::choices::{
    AaMethod, CheckFormat, Deny, DitherMethod, DrawingWarn, Dump, ExrPacking, Library, MessageFormat, Warn, When,
};
use super::values::{
    Antialias, Bytes, Clock, Declare, FileGamma, Frames, Gamma, Part, Pixel, Seconds, Share, Size, Stats, Version,
};
use crate::image_io::Format;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

const EXIT_CODES: &str = "\
Exit codes: 0 fine, 1 the scene is wrong, 2 the command line is wrong, 3 a snapshot differs, 4 a limit was reached, \
5 a file could not be read or written.

`durer scene.pov` and POV-Ray's own options work too: durer +Iscene.pov +W640 +H480 +A0.3";

/// Under `--help`, options stand below what they are about.
pub mod heading {
    /// Of which moment, and of what, the picture is.
    pub const DRAWN: &str = "What is drawn";
    /// How large, how good, and where it goes.
    pub const PICTURE: &str = "Picture";
    /// What else the scene may touch.
    pub const FILES: &str = "Files";
    /// How long, and with how much.
    pub const LIMITS: &str = "Limits";
    /// What is told beside the picture.
    pub const TOLD: &str = "What is told";
}
use heading::{DRAWN, FILES, LIMITS, PICTURE, TOLD};

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

/// The commands.
#[derive(Subcommand, Clone, Debug)]
pub enum Command {
    /// Draw scenes into picture files
    Render(Box<RenderArgs>),
    /// Read and evaluate scenes, draw nothing
    Check(CheckArgs),
    /// Tell what is seen through one pixel
    Pick(PickArgs),
    /// Draw each scene that has a snapshot beside it, and compare
    Test(TestArgs),
    /// Write scenes as they should look
    Fmt(FmtArgs),
    /// Write a first scene to change
    New(NewArgs),
    /// Show a scene's picture on a page while you write it
    #[cfg(feature = "watch")]
    Watch(Box<WatchArgs>),
    /// List a scene's cameras, lights, objects and textures
    Query(QueryArgs),
    /// Serve editors: messages, completion and the like, over standard input and output
    #[cfg(feature = "lsp")]
    Lsp(LspArgs),
    /// Explain the code of a message, such as E0203
    Explain(ExplainArgs),
    /// Print a script that completes durer's options in your shell
    Completions(CompletionsArgs),
}

/// What a scene is given when it is read.
#[derive(Args, Clone, Debug, Default)]
pub struct SceneArgs {
    /// Only this frame of an animation
    #[arg(help_heading = DRAWN, long, value_name = "N")]
    pub frame: Option<u32>,
    /// Of an INI file, or of POV-Ray's options.
    #[arg(skip)]
    pub animation: Option<Animation>,
    /// The value of `clock`; A..B from the first frame to the last [default: 0..1]
    #[arg(help_heading = DRAWN, long, value_name = "X", allow_hyphen_values = true)]
    pub clock: Option<Clock>,
    /// Declare a name: 2.5, '"text"', '<1,2,3>' or 'rgb <1,0,0>'
    #[arg(help_heading = DRAWN, long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub declare: Vec<Declare>,
    /// The version of the language, such as 3.1, until the scene's own `#version`
    #[arg(help_heading = DRAWN, long, value_name = "VERSION")]
    pub language: Option<Version>,
    /// Width and height in pixels [default: 640x480]
    #[arg(help_heading = PICTURE, long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Look for included files here too
    #[arg(help_heading = FILES, short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
    /// Whose standard include files
    #[arg(help_heading = FILES, long, value_name = "WHOSE", default_value = "installed", hide_possible_values = false)]
    pub library: Library,
    /// Let the scene read files below this folder too
    #[arg(help_heading = FILES, long, value_name = "DIR")]
    pub allow_read: Vec<PathBuf>,
    /// Let the scene write files below this folder too
    #[arg(help_heading = FILES, long, value_name = "DIR")]
    pub allow_write: Vec<PathBuf>,
    /// Take the text apart into single tokens: slow, and for tests, since what comes out is the same
    #[arg(long, hide = true)]
    pub single_tokens: bool,
    /// End with exit code 4 after so many statements
    #[arg(help_heading = LIMITS, long, value_name = "N", default_value_t = DEFAULT_STEPS)]
    pub max_steps: u64,
    /// End with exit code 4 when so much memory is needed, such as 2G [default: most of what is free]
    #[arg(help_heading = LIMITS, long, value_name = "BYTES")]
    pub max_memory: Option<Bytes>,
    /// End with exit code 4 after so many seconds
    #[arg(help_heading = LIMITS, long, value_name = "SECONDS")]
    pub max_time: Option<Seconds>,
}

/// Ends an endless loop within some ten seconds.
pub const DEFAULT_STEPS: u64 = 200_000_000;

/// How a picture is drawn.
#[derive(Args, Clone, Debug, Default)]
pub struct LookArgs {
    /// Smooth edges where neighbours differ by more than this, or `off` [default: 0.3]
    #[arg(help_heading = PICTURE, long, value_name = "THRESHOLD", allow_negative_numbers = true)]
    pub aa: Option<Antialias>,
    /// Where the samples of smooth edges lie [default: net]
    #[arg(help_heading = PICTURE, long, value_name = "METHOD")]
    pub aa_method: Option<AaMethod>,
    /// Rows and columns of `grid`, or depth of `corners` [default: 3]
    #[arg(help_heading = PICTURE, long, value_name = "1..9", value_parser = clap::value_parser!(u8).range(1..=9))]
    pub aa_depth: Option<u8>,
    /// How far samples of `grid` and `corners` are off their places at random, from 0 to 1 [default: 1]
    #[arg(help_heading = PICTURE, long, value_name = "AMOUNT", allow_negative_numbers = true)]
    pub aa_jitter: Option<Share>,
    /// Judge differences of neighbours after this gamma [default: 2.5]
    #[arg(help_heading = PICTURE, long, value_name = "GAMMA", allow_negative_numbers = true)]
    pub aa_gamma: Option<Gamma>,
    /// How much is drawn, from 0 (quick colours) to 11 (everything) [default: 9]
    #[arg(help_heading = PICTURE, long, value_name = "0..11", value_parser = clap::value_parser!(u8).range(0..=11))]
    pub quality: Option<u8>,
    /// Leave the background transparent
    #[arg(help_heading = PICTURE, long)]
    pub alpha: bool,
}

/// `durer render`.
#[derive(Args, Clone, Debug, Default)]
pub struct RenderArgs {
    /// Scenes, folders of scenes, INI files, or - for standard input
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
    /// The one of them that is drawn now.
    #[arg(skip)]
    pub input: PathBuf,
    /// Draw these frames, numbered with as many digits as B has [default: the INI file's]
    #[arg(help_heading = DRAWN, long, value_name = "A-B[:STEP]")]
    pub frames: Option<Frames>,
    /// Draw only this part of the picture
    #[arg(help_heading = DRAWN, long, value_name = "X,Y,W,H")]
    pub region: Option<Part>,
    /// The picture's file, a folder, or - for standard output [default: the input's name with .png, here]
    #[arg(help_heading = PICTURE, short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// A single frame of an INI file goes to a file of this very name.
    #[arg(skip)]
    pub exact_name: bool,
    /// The picture's format [default: by the output's ending; png for standard output]
    #[arg(help_heading = PICTURE, long, value_name = "FORMAT", value_parser = format_parser())]
    pub format: Option<String>,
    /// Bits for each channel [default: 8; 32 for exr]
    #[arg(help_heading = PICTURE, long, value_name = "8|16|32", value_parser = clap::builder::PossibleValuesParser::new(["8", "16", "32"]))]
    pub bit_depth: Option<String>,
    /// Keep brightness alone, 16 bits of it, as height fields do; png and ppm can
    #[arg(help_heading = PICTURE, long)]
    pub gray: bool,
    /// The curve that the numbers of png, jpg, ppm, bmp, tga and tiff follow: a gamma, or `srgb` [default: srgb]
    #[arg(help_heading = PICTURE, long, value_name = "GAMMA|srgb", allow_negative_numbers = true)]
    pub file_gamma: Option<FileGamma>,
    /// Round neighbours up and down in turn, so that more shades are seen than the file has
    #[arg(help_heading = PICTURE, long, value_name = "METHOD")]
    pub dither: Option<DitherMethod>,
    /// How exr is packed [default: rle]
    #[arg(help_heading = PICTURE, long, value_name = "HOW")]
    pub exr_packing: Option<ExrPacking>,
    /// Go on where a picture or an animation was left unfinished
    #[arg(help_heading = PICTURE, long)]
    pub resume: bool,
    /// Keep what is drawn from so many seconds on; for tests.
    #[arg(long, hide = true, value_name = "SECONDS", default_value = "1")]
    pub keep_after: Seconds,
    /// Whoever else may stop it.
    #[arg(skip)]
    pub stop: Option<std::sync::Arc<std::sync::atomic::AtomicBool>>,
    /// Draw, but write no picture
    #[arg(help_heading = PICTURE, long, conflicts_with_all = ["output", "format", "bit_depth"])]
    pub no_output: bool,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub look: LookArgs,
    /// How many threads draw [default: one for each processor]
    #[arg(help_heading = LIMITS, short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
    /// Warn of these too
    #[arg(help_heading = TOLD, long, value_name = "WHAT", value_delimiter = ',')]
    pub warn: Vec<DrawingWarn>,
    /// Show how far the picture is [default: auto]
    #[arg(help_heading = TOLD, long, value_name = "WHEN")]
    pub progress: Option<When>,
    /// Times, rays and memory as JSON: `json` for standard output, or a file
    #[arg(help_heading = TOLD, long, value_name = "json|FILE")]
    pub stats: Option<Stats>,
    /// Print what was understood as JSON, and draw nothing
    #[arg(help_heading = TOLD, long, value_name = "STAGE")]
    pub dump: Option<Dump>,
    /// Write the names of all files that were read, as a rule for make; as JSON if FILE ends in .json
    #[arg(help_heading = TOLD, long, value_name = "FILE")]
    pub deps: Option<PathBuf>,
}

fn format_parser() -> clap::builder::PossibleValuesParser {
    clap::builder::PossibleValuesParser::new(Format::names())
}

/// `durer check`.
#[derive(Args, Clone, Debug)]
pub struct CheckArgs {
    /// Scenes, folders of scenes, INI files, or - for standard input
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    /// How messages are written; all but `human` go to standard output
    #[arg(help_heading = TOLD, long, value_name = "FORMAT", default_value = "human")]
    pub format: CheckFormat,
    /// Let `warnings` fail as errors do
    #[arg(help_heading = TOLD, long, value_name = "WHAT")]
    pub deny: Option<Deny>,
    /// Warn of these too
    #[arg(help_heading = TOLD, long, value_name = "WHAT", value_delimiter = ',')]
    pub warn: Vec<Warn>,
}

/// `durer pick`.
#[derive(Args, Clone, Debug)]
pub struct PickArgs {
    /// The scene, an INI file, or - for standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Column and row, counted from 0 at the top left
    #[arg(value_name = "X,Y", allow_hyphen_values = true)]
    pub pixel: Pixel,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    /// As one JSON object
    #[arg(help_heading = TOLD, long)]
    pub json: bool,
}

/// `durer test`.
#[derive(Args, Clone, Debug)]
#[command(
    after_help = "The snapshot of chair.scene is chair.snapshot.png beside it. A scene may say how its snapshot is \
                        drawn, in a comment at its start:\n\n    //! test: --size 128x96 --aa off"
)]
pub struct TestArgs {
    /// Scenes and folders [default: the current folder]
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Take what is drawn now as the snapshot, of the scenes that are named or of all that differ; makes new ones for scenes that
    /// are named
    #[arg(long)]
    pub accept: bool,
    /// For a person, or one JSON object a line for each scene
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: MessageFormat,
    /// Write a page with the pictures side by side
    #[arg(long, value_name = "DIR")]
    pub report: Option<PathBuf>,
    /// Look for included files here too
    #[arg(help_heading = FILES, short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
    /// How many threads draw [default: one for each processor]
    #[arg(help_heading = LIMITS, short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
}

/// `durer fmt`.
#[derive(Args, Clone, Debug)]
pub struct FmtArgs {
    /// Scenes, include files, folders of them, or - for standard input [default: the current folder]
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Write nothing; list the files that would change, and end with exit code 1 if there are any
    #[arg(long)]
    pub check: bool,
    /// Write nothing; show what would change
    #[arg(long)]
    pub diff: bool,
    /// Break lines that are longer, where that can be done
    #[arg(long, value_name = "N", default_value_t = crate::format::WIDTH as u16, value_parser = clap::value_parser!(u16).range(40..=10_000))]
    pub width: u16,
}

/// `durer new`.
#[derive(Args, Clone, Debug)]
pub struct NewArgs {
    /// The scene's name; .scene is put behind it if it has no ending
    #[arg(value_name = "NAME")]
    pub name: PathBuf,
}

/// `durer watch`.
#[derive(Args, Clone, Debug)]
pub struct WatchArgs {
    /// The scene, or an INI file
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Where the page's button, or --no-page, writes [default: the input's name with .png, here]
    #[arg(help_heading = PICTURE, short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Open the page in your browser
    #[arg(long, conflicts_with = "no_page")]
    pub open: bool,
    /// Serve no page: write the picture again whenever a file is saved
    #[arg(long)]
    pub no_page: bool,
    /// The page's port on 127.0.0.1 [default: any that is free]
    #[arg(long, value_name = "N", default_value = "0", hide_default_value = true, conflicts_with = "no_page")]
    pub port: u16,
    /// What opens a place, such as 'vi +{line} {file}' [default: a link to Visual Studio Code]
    #[arg(long, value_name = "COMMAND", conflicts_with = "no_page")]
    pub editor: Option<super::values::Command>,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub look: LookArgs,
    /// How many threads draw [default: one for each processor]
    #[arg(help_heading = LIMITS, short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
}

/// `durer query`.
#[derive(Args, Clone, Debug)]
pub struct QueryArgs {
    /// The scene, an INI file, or - for standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    /// As one JSON object
    #[arg(help_heading = TOLD, long)]
    pub json: bool,
}

/// `durer lsp`.
#[derive(Args, Clone, Debug)]
pub struct LspArgs {
    /// Understood and needless: nothing else is spoken
    #[arg(long, hide = true)]
    pub stdio: bool,
    /// Look for included files here too
    #[arg(help_heading = FILES, short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
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
