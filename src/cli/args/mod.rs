//! Options of the command line, in the form that clap reads.

mod choices;
mod untrusted;
pub mod values;
pub use untrusted::{MAX_PIXELS as MAX_UNTRUSTED_PIXELS, environment_is_untrusted};

use crate::image_io::Format;
pub use choices::{
    AaMethod, CheckFormat, Deny, DitherMethod, DrawingWarn, Dump, Library, MessageFormat, Outside, PackingMethod,
    ProgressDisplay, Warn, When,
};
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use values::{
    Antialias, Bytes, Clock, Declare, FileGamma, Frames, Gamma, Part, Pixel, Seconds, ShardChoice, Share, Size, Stats,
    Version,
};

const EXIT_CODES: &str = "\
Exit codes: 0 success, 1 error in the scene, 2 error in the command line, 3 a snapshot differs, 4 a limit was reached, \
5 a file could not be read or written, 75 a shard was terminated and can be continued, 128 + N ended by signal N (130 after Ctrl-C).

`durer scene.pov` and POV-Ray's own options work too: durer +Iscene.pov +W640 +H480 +A0.3";

/// Headings that group the options in `--help`.
pub mod heading {
    /// Heading of options about the time and content of the picture.
    pub const SCENE: &str = "Scene";
    /// Heading of options about size, quality and destination of the picture.
    pub const PICTURE: &str = "Picture";
    /// Heading of options about the files that the scene may access.
    pub const FILES: &str = "Files";
    /// Heading of options that limit time and memory.
    pub const LIMITS: &str = "Limits";
    /// Heading of options about messages and reports.
    pub const OUTPUT: &str = "Output";
}
use heading::{FILES, LIMITS, OUTPUT, PICTURE, SCENE};

/// Renders scenes written by hand in POV-Ray's scene language.
///
/// durer draws everything that POV-Ray 3.7 draws: all its shapes, patterns, warps, lights and cameras, media, radiosity,
/// photons and subsurface light.
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

/// Options of every command.
#[derive(Args, Clone, Copy, Debug)]
pub struct Common {
    /// Print errors only
    #[arg(short, long, global = true)]
    pub quiet: bool,
    /// Print messages in colour
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto", hide_possible_values = false)]
    pub color: When,
}

/// Commands of the program `durer`.
#[derive(Subcommand, Clone, Debug)]
pub enum Command {
    /// Render scenes into picture files
    Render(Box<RenderArgs>),
    /// Read and evaluate scenes without rendering
    Check(CheckArgs),
    /// Describe the object that one pixel shows
    Pick(PickArgs),
    /// Compute a picture's photons and radiosity once for all of its shards
    Prepare(Box<PrepareArgs>),
    /// Combine the shards of a picture
    Merge(MergeArgs),
    /// Render each scene that has a snapshot, and compare
    Test(TestArgs),
    /// Format scenes
    Fmt(FmtArgs),
    /// Create a new scene
    New(NewArgs),
    /// Show a scene's picture on a page while you edit the scene
    #[cfg(feature = "watch")]
    Watch(Box<WatchArgs>),
    /// List a scene's cameras, lights, objects and textures
    Query(QueryArgs),
    /// Run the language server on standard input and output
    #[cfg(feature = "lsp")]
    Lsp(LspArgs),
    /// Explain a message code such as E0203
    Explain(ExplainArgs),
    /// Print a script that completes durer's options in your shell
    Completions(CompletionsArgs),
}

/// Options for reading and evaluating a scene.
#[derive(Args, Clone, Debug, Default)]
pub struct SceneArgs {
    /// Render only this frame of an animation
    #[arg(help_heading = SCENE, long, value_name = "N")]
    pub frame: Option<u32>,
    /// Value of `clock`; A..B from the first to the last frame [default: 0..1]
    #[arg(help_heading = SCENE, long, value_name = "X", allow_hyphen_values = true)]
    pub clock: Option<Clock>,
    /// Declare an identifier: 2.5, '"text"', '<1,2,3>' or 'rgb <1,0,0>'
    #[arg(help_heading = SCENE, long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub declare: Vec<Declare>,
    /// Include this file before the scene
    #[arg(help_heading = SCENE, long, value_name = "FILE")]
    pub header: Option<String>,
    /// Language version, such as 3.1, until the scene's own `#version`
    #[arg(help_heading = SCENE, long, value_name = "VERSION")]
    pub language: Option<Version>,
    /// Width and height in pixels [default: 640x480]
    #[arg(help_heading = PICTURE, long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Add a folder to the include path
    #[arg(help_heading = FILES, short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
    /// Choose the standard include files
    #[arg(help_heading = FILES, long, value_name = "WHOSE", default_value = "installed", hide_possible_values = false)]
    pub library: Library,
    /// Distrust scene and INI file: they read below their folder alone, write nothing, and have limits
    #[arg(help_heading = FILES, long)]
    pub untrusted: bool,
    /// Allow an untrusted scene to read files below this folder
    #[arg(help_heading = FILES, long, value_name = "DIR")]
    pub allow_read: Vec<PathBuf>,
    /// Allow the scene to create and replace files below this folder
    #[arg(help_heading = FILES, long, value_name = "DIR")]
    pub allow_write: Vec<PathBuf>,
    /// Parse single tokens only; slow, with the same result (for tests)
    #[arg(long, hide = true)]
    pub single_tokens: bool,
    /// End with exit code 4 after N statements
    #[arg(help_heading = LIMITS, long, value_name = "N", default_value_t = DEFAULT_STEPS)]
    pub max_steps: u64,
    /// End with exit code 4 above this memory, such as 2G [default: most of the free memory]
    #[arg(help_heading = LIMITS, long, value_name = "BYTES")]
    pub max_memory: Option<Bytes>,
    /// End with exit code 4 after this time
    #[arg(help_heading = LIMITS, long, value_name = "SECONDS")]
    pub max_time: Option<Seconds>,
}

/// Default of `--max-steps`: an endless loop ends after about ten seconds.
pub const DEFAULT_STEPS: u64 = 200_000_000;

/// Quality of a picture.
#[derive(Args, Clone, Debug, Default)]
pub struct LookArgs {
    /// Threshold of anti-aliasing, the difference of neighbouring pixels, or `off` [default: 0.3]
    #[arg(help_heading = PICTURE, long, value_name = "THRESHOLD", allow_negative_numbers = true)]
    pub aa: Option<Antialias>,
    /// Sample layout of anti-aliasing [default: net]
    #[arg(help_heading = PICTURE, long, value_name = "METHOD")]
    pub aa_method: Option<AaMethod>,
    /// Rows and columns of `grid`, or depth of `corners` [default: 3]
    #[arg(help_heading = PICTURE, long, value_name = "1..9", value_parser = clap::value_parser!(u8).range(1..=9))]
    pub aa_depth: Option<u8>,
    /// Random offset of the samples of `grid` and `corners`, from 0 to 1 [default: 1]
    #[arg(help_heading = PICTURE, long, value_name = "AMOUNT", allow_negative_numbers = true)]
    pub aa_jitter: Option<Share>,
    /// Gamma applied before pixels are compared with the threshold [default: 2.5]
    #[arg(help_heading = PICTURE, long, value_name = "GAMMA", allow_negative_numbers = true)]
    pub aa_gamma: Option<Gamma>,
    /// Rendering quality, from 0 (quick colours) to 11 (all effects) [default: 9]
    #[arg(help_heading = PICTURE, long, value_name = "0..11", value_parser = clap::value_parser!(u8).range(0..=11))]
    pub quality: Option<u8>,
    /// Make the background transparent
    #[arg(help_heading = PICTURE, long)]
    pub alpha: bool,
}

/// Options of `durer render`.
#[derive(Args, Clone, Debug, Default)]
pub struct RenderArgs {
    /// Scenes, folders of scenes, INI files, or - for standard input
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
    /// Render these frames; file names have as many digits as B [default: frames of the INI file]
    #[arg(help_heading = SCENE, long, value_name = "A-B[:STEP]")]
    pub frames: Option<Frames>,
    /// Render only this part of the picture
    #[arg(help_heading = SCENE, long, value_name = "X,Y,W,H")]
    pub region: Option<Part>,
    /// Pixels outside of the region [default: transparent]
    #[arg(help_heading = SCENE, long, value_name = "WHAT")]
    pub outside: Option<Outside>,
    /// Output file, a folder, or - for standard output [default: the input's name with .png, here]
    #[arg(help_heading = PICTURE, short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Picture format [default: by the ending of the output; png for standard output]
    #[arg(help_heading = PICTURE, long, value_name = "FORMAT", value_parser = picture_format_parser())]
    pub format: Option<String>,
    /// Bits per channel [default: 8; 32 for exr]
    #[arg(help_heading = PICTURE, long, value_name = "8|16|32", value_parser = clap::builder::PossibleValuesParser::new(["8", "16", "32"]))]
    pub bit_depth: Option<String>,
    /// Write 16-bit grayscale, as for height fields (png and ppm only)
    #[arg(help_heading = PICTURE, long)]
    pub gray: bool,
    /// Transfer curve of png, jpg, ppm, bmp, tga and tiff: a gamma, or `srgb` [default: srgb]
    #[arg(help_heading = PICTURE, long, value_name = "GAMMA|srgb", allow_negative_numbers = true)]
    pub file_gamma: Option<FileGamma>,
    /// Dither, to show more shades than the file can store
    #[arg(help_heading = PICTURE, long, value_name = "METHOD")]
    pub dither: Option<DitherMethod>,
    /// Compression of exr [default: rle] or tga [default: none]
    #[arg(help_heading = PICTURE, long, value_name = "HOW")]
    pub packing: Option<PackingMethod>,
    /// Render shard K of N of the picture, for `durer merge`; `auto` or auto/N: the scheduler's task
    #[arg(help_heading = PICTURE, long, value_name = "K/N", conflicts_with_all = ["no_output", "dump"])]
    pub shard: Option<ShardChoice>,
    /// Continue an unfinished picture or animation
    #[arg(help_heading = PICTURE, long)]
    pub resume: bool,
    /// Write the resume journal after this time (for tests)
    #[arg(long, hide = true, value_name = "SECONDS", default_value = "1")]
    pub keep_after: Seconds,
    /// Use the radiosity samples of this file
    #[arg(help_heading = FILES, long, value_name = "FILE")]
    pub load_radiosity: Option<PathBuf>,
    /// Save the radiosity samples to this file
    #[arg(help_heading = FILES, long, value_name = "FILE")]
    pub save_radiosity: Option<PathBuf>,
    /// Use the photons and radiosity samples that `durer prepare` has computed for this picture
    #[arg(help_heading = FILES, long, value_name = "FILE")]
    pub prepared: Option<PathBuf>,
    /// Render without writing a picture
    #[arg(help_heading = PICTURE, long, conflicts_with_all = ["output", "format", "bit_depth"])]
    pub no_output: bool,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub look: LookArgs,
    /// Number of threads [default: one for each processor]
    #[arg(help_heading = LIMITS, short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
    /// Enable additional warnings
    #[arg(help_heading = OUTPUT, long, value_name = "WHAT", value_delimiter = ',')]
    pub warn: Vec<DrawingWarn>,
    /// Show progress [default: auto]
    #[arg(help_heading = OUTPUT, long, value_name = "HOW")]
    pub progress: Option<ProgressDisplay>,
    /// Write times, numbers of rays and memory as JSON: `json` for standard output, or a file
    #[arg(help_heading = OUTPUT, long, value_name = "json|FILE")]
    pub stats: Option<Stats>,
    /// Print a stage as JSON instead of rendering
    #[arg(help_heading = OUTPUT, long, value_name = "STAGE")]
    pub dump: Option<Dump>,
    /// Write the names of all files that were read, as a rule for make, or as JSON if FILE ends in .json
    #[arg(help_heading = OUTPUT, long, value_name = "FILE")]
    pub deps: Option<PathBuf>,
}

fn picture_format_parser() -> clap::builder::PossibleValuesParser {
    clap::builder::PossibleValuesParser::new(Format::names())
}

/// Options of `durer prepare`.
#[derive(Args, Clone, Debug)]
pub struct PrepareArgs {
    /// The scene, an INI file, or - for standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Output file [default: the input's name with .prepared, here]
    #[arg(help_heading = FILES, short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub look: LookArgs,
    /// Number of threads [default: one for each processor]
    #[arg(help_heading = LIMITS, short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
    /// Show progress [default: auto]
    #[arg(help_heading = OUTPUT, long, value_name = "HOW")]
    pub progress: Option<ProgressDisplay>,
}

/// Options of `durer merge`.
#[derive(Args, Clone, Debug)]
pub struct MergeArgs {
    /// The picture that the shards were rendered for
    #[arg(value_name = "PICTURE")]
    pub picture: PathBuf,
    /// Files of the shards, or pictures of parts [default: all PICTURE.shard-K-of-N beside the picture]
    #[arg(value_name = "SHARD")]
    pub shards: Vec<PathBuf>,
}

/// Options of `durer check`.
#[derive(Args, Clone, Debug)]
pub struct CheckArgs {
    /// Scenes, folders of scenes, INI files, or - for standard input
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    /// Format of messages; all but `human` go to standard output
    #[arg(help_heading = OUTPUT, long, value_name = "FORMAT", default_value = "human")]
    pub format: CheckFormat,
    /// Treat `warnings` as errors
    #[arg(help_heading = OUTPUT, long, value_name = "WHAT")]
    pub deny: Option<Deny>,
    /// Enable additional warnings
    #[arg(help_heading = OUTPUT, long, value_name = "WHAT", value_delimiter = ',')]
    pub warn: Vec<Warn>,
}

/// Options of `durer pick`.
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
    /// Print one JSON object
    #[arg(help_heading = OUTPUT, long)]
    pub json: bool,
}

/// Options of `durer test`.
#[derive(Args, Clone, Debug)]
#[command(
    after_help = "The snapshot of chair.scene is chair.snapshot.png beside it. A comment at the start of a scene \
                        gives options for its snapshot:\n\n    //! test: --size 128x96 --aa off"
)]
pub struct TestArgs {
    /// Scenes and folders [default: the current folder]
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Replace differing snapshots of the named scenes, or of all scenes; create missing snapshots of named scenes
    #[arg(long)]
    pub accept: bool,
    /// Format of the results: for people, or one JSON object a line for each scene
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: MessageFormat,
    /// Write a page that shows the pictures side by side
    #[arg(long, value_name = "DIR")]
    pub report: Option<PathBuf>,
    /// Compare all bits of the pixels with the hashes in a file, too; with --accept, write the file
    #[arg(long, value_name = "FILE")]
    pub hashes: Option<PathBuf>,
    /// Add a folder to the include path
    #[arg(help_heading = FILES, short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
    /// Number of threads [default: one for each processor]
    #[arg(help_heading = LIMITS, short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
}

/// Options of `durer fmt`.
#[derive(Args, Clone, Debug)]
pub struct FmtArgs {
    /// Scenes, include files, folders of them, or - for standard input [default: the current folder]
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Write nothing; list files that would change, and end with exit code 1 if there are any
    #[arg(long)]
    pub check: bool,
    /// Write nothing; show the changes
    #[arg(long)]
    pub diff: bool,
    /// Break longer lines where possible
    #[arg(long, value_name = "N", default_value_t = crate::format::WIDTH as u16, value_parser = clap::value_parser!(u16).range(40..=10_000))]
    pub width: u16,
}

/// Options of `durer new`.
#[derive(Args, Clone, Debug)]
pub struct NewArgs {
    /// Name of the scene; .scene is appended if it has no ending
    #[arg(value_name = "NAME")]
    pub name: PathBuf,
}

/// Options of `durer watch`.
#[derive(Args, Clone, Debug)]
pub struct WatchArgs {
    /// The scene, or an INI file
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Output file of the page's button or of --no-page [default: the input's name with .png, here]
    #[arg(help_heading = PICTURE, short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Open the page in your browser
    #[arg(long, conflicts_with = "no_page")]
    pub open: bool,
    /// Serve no page; write the picture after each change
    #[arg(long)]
    pub no_page: bool,
    /// Port of the page on 127.0.0.1 [default: a free port]
    #[arg(long, value_name = "N", default_value = "0", hide_default_value = true, conflicts_with = "no_page")]
    pub port: u16,
    /// Command that opens a position, such as 'vi +{line} {file}' [default: a link to Visual Studio Code]
    #[arg(long, value_name = "COMMAND", conflicts_with = "no_page")]
    pub editor: Option<values::Command>,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub look: LookArgs,
    /// Number of threads [default: one for each processor]
    #[arg(help_heading = LIMITS, short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
}

/// Options of `durer query`.
#[derive(Args, Clone, Debug)]
pub struct QueryArgs {
    /// The scene, an INI file, or - for standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    #[command(flatten)]
    #[allow(missing_docs)]
    pub scene: SceneArgs,
    /// Print one JSON object
    #[arg(help_heading = OUTPUT, long)]
    pub json: bool,
}

/// Options of `durer lsp`.
#[derive(Args, Clone, Debug)]
pub struct LspArgs {
    /// Accepted without effect: the server always uses standard input and output
    #[arg(long, hide = true)]
    pub stdio: bool,
    /// Add a folder to the include path
    #[arg(help_heading = FILES, short = 'I', long = "include", value_name = "DIR")]
    pub include: Vec<PathBuf>,
}

/// Options of `durer explain`.
#[derive(Args, Clone, Debug)]
pub struct ExplainArgs {
    /// Code of the message; without it, all codes are listed
    #[arg(value_name = "CODE")]
    pub code: Option<String>,
}

/// Options of `durer completions`.
#[derive(Args, Clone, Debug)]
pub struct CompletionsArgs {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

impl SceneArgs {
    /// Returns the width and height of the picture: 640x480 without `--size`.
    pub fn size(&self) -> Size {
        self.size.unwrap_or_default()
    }
}
