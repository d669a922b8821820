//! Destination and format of pictures.

use super::picture_writer::PictureWriter;
use crate::cli::args::{DitherMethod, LookArgs, Outside, PackingMethod, RenderArgs};
use crate::cli::console::Console;
use crate::cli::exit::{Result, usage_error};
use crate::cli::shard::{self, Header, ShardWriter};
use crate::diagnostic::{Diagnostic, codes, file};
use crate::image_io::{self, Dither, Encoding, Format, Packing};
use crate::render::Shard;
use crate::snapshot;
use crate::source::{Disk, Draft, Files, Span};
use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Destination and encoding of a command's pictures.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    location: Location,
    encoding: Encoding,
    /// Share of the picture that goes to the location; `None` for the whole picture.
    shard: Option<Shard>,
}

#[derive(Clone, Debug, PartialEq)]
enum Location {
    Nowhere,
    Stdout,
    File(PathBuf),
}

impl Target {
    /// Creates the destination that `-o`, `--format` and `--bit-depth` describe. A format that can't hold the picture
    /// is an error now, not after hours.
    pub fn new(input: &Path, args: &RenderArgs) -> Result<Self> {
        let named = args.format.as_deref().and_then(Format::from_name);
        let location = match &args.output {
            _ if args.no_output => Location::Nowhere,
            Some(path) if path == Path::new("-") => Location::Stdout,
            Some(path) if is_folder(path) => Location::File(path.join(default_name(input, named))),
            Some(path) => Location::File(path.clone()),
            None => Location::File(default_name(input, named)),
        };
        let format = match (&location, named) {
            (_, Some(format)) => format,
            (Location::File(path), None) => Format::from_path(path)?,
            _ => Format::Png,
        };
        let depth = args.bit_depth.as_ref().and_then(|depth| depth.parse().ok()).or(args.gray.then_some(16));
        if args.gray && !format.has_gray() {
            let text = format!("{} can't hold brightness alone", format.name());
            return Err(Box::new(Diagnostic::new(codes::FORMAT_LIMIT, Span::NONE, text).help("png and ppm can")).into());
        }
        let size = args.scene.size();
        if location != Location::Nowhere {
            format.check_limits(size.width, size.height, depth)?;
        }
        if let Location::File(path) = &location
            && is_same_file(path, input)
        {
            return usage_error(format!("the picture would overwrite the scene `{}`", path.display()));
        }
        if let Location::File(path) = &location
            && snapshot::is_snapshot(path)
        {
            let path = path.display();
            return usage_error(format!("`{path}` is a snapshot: only `durer test --accept` writes it"));
        }
        if let Some(packing) = args.packing
            && !(format == Format::Exr || format == Format::Tga && packing != PackingMethod::Zip)
        {
            let choices = if format == Format::Tga { "tga has `none` and `rle`" } else { "exr and tga have a choice" };
            return usage_error(format!("{} has no such compression: {choices}", format.name()));
        }
        if args.look.alpha && !format.has_alpha() {
            return usage_error(format!("{} can't hold the transparency that `--alpha` asks for", format.name()));
        }
        Ok(Self { location, encoding: encoding(args, format, depth), shard: None })
    }

    /// Creates the destination of a whole picture with a known encoding.
    pub fn of_file(path: &Path, encoding: Encoding) -> Self {
        Self { location: Location::File(path.to_path_buf()), encoding, shard: None }
    }

    /// Returns the destination of a shard of this picture: a file beside the picture. A destination that is not a file stays
    /// as it is.
    pub fn of_shard(&self, shard: Shard) -> Self {
        let Location::File(path) = &self.location else { return self.clone() };
        Self { location: Location::File(shard::path_beside(path, shard)), shard: Some(shard), ..self.clone() }
    }

    /// Returns the share of the picture that goes to this destination; `None` for the whole picture.
    pub fn shard(&self) -> Option<Shard> {
        self.shard
    }

    /// Returns the format and options of the picture's file; for a shard, those of the file of the whole picture.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// True if the picture goes to standard output.
    pub fn is_stdout(&self) -> bool {
        self.location == Location::Stdout
    }

    /// Returns the file that is written, which is the shard's own file for a shard; `None` for standard output and for no
    /// output.
    pub fn file(&self) -> Option<&Path> {
        match &self.location {
            Location::File(path) => Some(path),
            _ => None,
        }
    }

    /// Checks that the destination takes several pictures. On standard output, only ppm files may follow one another.
    pub fn check_takes_many_frames(&self) -> Result<()> {
        match (&self.location, self.encoding.format) {
            (Location::Stdout, format) if format != Format::Ppm => usage_error(format!(
                "many frames on standard output can't be {}: add `--format ppm`, or name a file: `-o film.png`",
                format.name()
            )),
            _ => Ok(()),
        }
    }

    /// True if the file's name contains a pattern such as `%03d` for the frame's number.
    pub fn has_number_pattern(&self) -> bool {
        self.file()
            .and_then(Path::file_name)
            .is_some_and(|name| number_placeholder_and_width(&name.to_string_lossy()).is_some())
    }

    /// Returns the destination of one frame. `%03d` in the name is replaced by the frame number with at least three
    /// digits. Without a pattern, the number with at least `default_digits` digits precedes the extension. Standard output
    /// stays as it is.
    pub fn numbered(&self, frame: u32, default_digits: usize) -> Self {
        let Location::File(path) = &self.location else {
            return self.clone();
        };
        let whole = path.file_name().unwrap_or_default().to_string_lossy();
        let name = if let Some((range, least)) = number_placeholder_and_width(&whole) {
            format!("{}{frame:0least$}{}", &whole[..range.start], &whole[range.end..]).into()
        } else {
            let mut name = path.file_stem().unwrap_or_default().to_os_string();
            name.push(format!("{frame:0default_digits$}"));
            if let Some(ending) = path.extension() {
                name.push(".");
                name.push(ending);
            }
            name
        };
        Self { location: Location::File(path.with_file_name(name)), ..self.clone() }
    }

    /// Checks that the picture's file, if it has one, can be written and would replace only a picture, a shard or an empty
    /// file (E0004).
    pub fn check_file_writable(&self) -> Result<()> {
        match &self.location {
            Location::File(path) => {
                check_replaces_only_picture(path)?;
                Ok(Disk.check_writable(path).map_err(|e| file::unwritable(&Disk, path, &e)).map_err(Box::new)?)
            }
            _ => Ok(()),
        }
    }

    /// Starts the picture's file, in memory for standard output; `None` if the picture has no destination.
    pub fn start_draft(&self) -> Result<Option<Draft>> {
        Ok(match &self.location {
            Location::Nowhere => None,
            Location::Stdout => Some(Draft::in_memory(Path::new("-"))),
            Location::File(path) => Some(Disk.draft(path).map_err(|e| Box::new(file::unwritable(&Disk, path, &e)))?),
        })
    }

    /// Creates the writer of a picture of `size`, width by height in pixels, into a draft. Without a draft, the rows are
    /// discarded.
    pub fn writer<'d>(&'d self, draft: Option<&'d mut Draft>, size: (usize, usize)) -> Result<PictureWriter<'d>> {
        let path = self.file().unwrap_or(Path::new("standard output"));
        let unwritable = |e: &std::io::Error| file::unwritable(&Disk, path, e);
        Ok(PictureWriter::new(draft, size, &self.encoding, unwritable)?)
    }

    /// Creates the writer of a shard into a draft.
    pub fn shard_writer<'d>(&'d self, draft: &'d mut Draft, header: &Header) -> Result<ShardWriter<'d>> {
        let path = self.file().unwrap_or(Path::new("standard output"));
        Ok(ShardWriter::new(draft, header, |e: &std::io::Error| file::unwritable(&Disk, path, e))?)
    }

    /// Gives the finished file its name, and returns its path. A picture for standard output is printed now, and `None` is
    /// returned.
    pub fn commit(&self, console: &Console, draft: Option<Draft>) -> Result<Option<&Path>> {
        match (&self.location, draft) {
            (Location::Stdout, Some(draft)) => console.write_to_stdout(draft.into_memory_bytes()).map(|()| None),
            (Location::File(path), Some(draft)) => {
                draft.commit(&Disk).map_err(|e| Box::new(file::unwritable(&Disk, path, &e)))?;
                Ok(Some(path))
            }
            _ => Ok(None),
        }
    }

    /// Returns a text with all options of the encoding, which change the file but not the pixels.
    pub fn encoding_options(&self) -> String {
        format!(" {:?}", self.encoding)
    }

    /// Returns the memory that each pixel occupies until the file is finished, in bytes.
    pub fn kept_bytes_per_pixel(&self) -> usize {
        if self.location == Location::Nowhere { 0 } else { self.encoding.buffered_bytes_per_pixel() }
    }
}

/// Refuses to replace a regular file that is neither a picture, nor a shard, nor empty. A file that cannot be read is
/// accepted, because writing will fail.
fn check_replaces_only_picture(path: &Path) -> Result<()> {
    let mut start = Vec::with_capacity(image_io::SIGNATURE_BYTES);
    let is_regular = path.metadata().is_ok_and(|metadata| metadata.is_file());
    let Some(file) = is_regular.then(|| File::open(path).ok()).flatten() else { return Ok(()) };
    let read = file.take(image_io::SIGNATURE_BYTES as u64).read_to_end(&mut start);
    let is_ours = image_io::begins_like_a_picture(&start) || shard::begins_like_a_shard(&start);
    if read.is_err() || start.is_empty() || is_ours {
        return Ok(());
    }
    let text = format!("`{}` is not a picture, and is not replaced by one", path.display());
    let fault = Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, text);
    Err(Box::new(fault.help("move it away, or give the picture another name with `-o`")).into())
}

fn encoding(args: &RenderArgs, format: Format, bits_per_channel: Option<u8>) -> Encoding {
    let plain = Encoding::new(format);
    Encoding {
        format,
        depth: bits_per_channel.unwrap_or(plain.depth),
        gray: args.gray,
        alpha: may_be_transparent(&args.look, args),
        gamma: args.file_gamma.map_or(plain.gamma, |gamma| gamma.0),
        dither: args.dither.map(|method| match method {
            DitherMethod::B2 => Dither::Bayer(2),
            DitherMethod::B3 => Dither::Bayer(3),
            DitherMethod::B4 => Dither::Bayer(4),
            DitherMethod::D1 => Dither::Row,
            DitherMethod::D2 => Dither::Simple,
            DitherMethod::Fs => Dither::FloydSteinberg,
        }),
        packing: args.packing.map_or(plain.packing, |packing| match packing {
            PackingMethod::None => Packing::None,
            PackingMethod::Rle => Packing::Runs,
            PackingMethod::Zip => Packing::Zip,
        }),
    }
}

/// True if the picture may have transparent pixels: with `--alpha`, and outside of `--region` without `--outside black`. The
/// format need not be able to hold them.
fn may_be_transparent(look: &LookArgs, args: &RenderArgs) -> bool {
    look.alpha || args.region.is_some() && args.outside != Some(Outside::Black)
}

fn is_same_file(a: &Path, b: &Path) -> bool {
    a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}

/// Finds `%d` or `%03d` in a name, as in C and ffmpeg; returns its byte range and the minimum number of digits, at most 20.
fn number_placeholder_and_width(name: &str) -> Option<(Range<usize>, usize)> {
    name.match_indices('%').find_map(|(at, _)| {
        let digits = name[at + 1..].bytes().take_while(u8::is_ascii_digit).count();
        let end = at + 1 + digits;
        let width = if digits == 0 { Some(1) } else { name[at + 1..end].parse().ok().filter(|width| *width <= 20) };
        width.filter(|_| name[end..].starts_with('d')).map(|width| (at..end + 1, width))
    })
}

/// True if the path is an existing folder, or ends with a separator.
pub fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with(std::path::is_separator)
}

/// Returns the default output file: the name of `input` without its folder, with the extension of `format` (`None`: png).
fn default_name(input: &Path, format: Option<Format>) -> PathBuf {
    let stem =
        if input == Path::new("-") { Path::new("stdin").as_os_str() } else { input.file_stem().unwrap_or_default() };
    let mut name = stem.to_os_string();
    name.push(".");
    name.push(format.unwrap_or(Format::Png).name());
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::args::{Cli, Command};
    use clap::Parser;

    fn target(line: &str) -> Result<Target> {
        let cli = Cli::try_parse_from(format!("durer render {line}").split(' ')).unwrap();
        let Command::Render(args) = cli.command else { unreachable!() };
        Target::new(&args.inputs[0], &args)
    }

    fn file(line: &str) -> String {
        match target(line).unwrap().location {
            Location::File(path) => path.display().to_string(),
            other => format!("{other:?}"),
        }
    }

    #[test]
    fn pictures_have_the_scenes_name_unless_named() {
        assert_eq!(file("a/b.scene"), "b.png");
        assert_eq!(file("a/b.scene --format exr"), "b.exr");
        assert_eq!(file("-"), "stdin.png");
        assert_eq!(file("b.scene -o c/d.jpg"), "c/d.jpg");
        assert_eq!(file("b.scene -o nowhere/"), "nowhere/b.png");
        assert_eq!(file("b.scene -o -"), "Stdout");
        assert_eq!(file("b.scene --no-output"), "Nowhere");
    }

    #[test]
    fn frames_are_numbered() {
        let numbered = |line: &str, digits| target(line).unwrap().numbered(7, digits).location;
        assert_eq!(numbered("b.scene -o c/d.png", 2), Location::File("c/d07.png".into()));
        assert_eq!(numbered("b.scene -o c/d%03d_.png", 2), Location::File("c/d007_.png".into()));
        assert_eq!(numbered("b.scene -o 100%/%d%%.png", 2), Location::File("100%/7%%.png".into()));
        assert_eq!(numbered("b.scene -o 5%5.png", 1), Location::File("5%57.png".into()));
        assert_eq!(number_placeholder_and_width("a%9999999999999999999999d"), None);
    }

    #[test]
    fn formats_that_cannot_hold_the_picture_are_refused() {
        for line in [
            "-o a.jpg --bit-depth 16",
            "-o a.exr --bit-depth 8",
            "-o a.jpg --alpha",
            "-o a.png --packing rle",
            "-o a.tga --packing zip",
            "-o a.xyz",
            "-o a",
            "-o a.jpg --size 70000x10",
        ] {
            assert!(target(&format!("b.scene {line}")).is_err(), "{line}");
        }
        assert!(target("b.scene -o - --format ppm --bit-depth 16").is_ok());
        assert!(target("b.scene -o - --format ppm").unwrap().check_takes_many_frames().is_ok());
        assert!(target("b.scene -o -").unwrap().check_takes_many_frames().is_err());
    }
}
