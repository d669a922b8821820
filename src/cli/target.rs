//! Where pictures go, and as what.

use super::args::{DitherMethod, ExrPacking, LookArgs, RenderArgs};
use super::canvas::Canvas;
use super::console::Console;
use super::exit::{Result, usage};
use super::values::Size;
use crate::diagnostic::{Diagnostic, codes, file};
use crate::image_io::{Dither, Encoding, Format, Packing};
use crate::snapshot;
use crate::source::{Disk, Draft, Files, Span};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Where the pictures of one command go.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    place: Place,
    encoding: Encoding,
}

#[derive(Clone, Debug, PartialEq)]
enum Place {
    Nowhere,
    Stdout,
    File(PathBuf),
}

impl Target {
    /// As `-o`, `--format` and `--bit-depth` say. A format that can't hold the picture is an error now, not after hours.
    pub fn new(args: &RenderArgs) -> Result<Self> {
        let named = args.format.as_deref().and_then(Format::from_name);
        let place = match &args.output {
            _ if args.no_output => Place::Nowhere,
            Some(path) if path == Path::new("-") => Place::Stdout,
            Some(path) if is_folder(path) => Place::File(path.join(default_name(&args.input, named))),
            Some(path) => Place::File(path.clone()),
            None => Place::File(default_name(&args.input, named)),
        };
        let format = match (&place, named) {
            (_, Some(format)) => format,
            (Place::File(path), None) => Format::from_path(path)?,
            _ => Format::Png,
        };
        let depth = args.bit_depth.as_ref().and_then(|depth| depth.parse().ok()).or(args.gray.then_some(16));
        if args.gray && !format.has_gray() {
            let text = format!("{} can't hold brightness alone", format.name());
            return Err(Box::new(Diagnostic::new(codes::FORMAT_LIMIT, Span::NONE, text).help("png and ppm can")).into());
        }
        let size = args.scene.size();
        if place != Place::Nowhere {
            format.check(size.width, size.height, depth)?;
        }
        if let Place::File(path) = &place
            && is_same(path, &args.input)
        {
            return usage(format!("the picture would take the place of the scene `{}`", path.display()));
        }
        if let Place::File(path) = &place
            && snapshot::is_snapshot(path)
        {
            let path = path.display();
            return usage(format!("`{path}` is a snapshot: only `durer test --accept` writes it"));
        }
        if args.look.alpha && !format.has_alpha() {
            return usage(format!("{} can't hold the transparency that `--alpha` asks for", format.name()));
        }
        Ok(Self { place, encoding: encoding(args, format, depth) })
    }

    /// Does the picture go to standard output?
    pub fn is_stdout(&self) -> bool {
        self.place == Place::Stdout
    }

    /// The file, if there is one.
    pub fn file(&self) -> Option<&Path> {
        match &self.place {
            Place::File(path) => Some(path),
            _ => None,
        }
    }

    /// Can many pictures go there? On standard output one follows the other, which only ppm was made for.
    pub fn check_many(&self) -> Result<()> {
        match (&self.place, self.encoding.format) {
            (Place::Stdout, format) if format != Format::Ppm => usage(format!(
                "many frames on standard output can't be {}: add `--format ppm`, or name a file: `-o film.png`",
                format.name()
            )),
            _ => Ok(()),
        }
    }

    /// Does the name say where the number of a frame stands?
    pub fn has_pattern(&self) -> bool {
        self.file().and_then(Path::file_name).is_some_and(|name| pattern(&name.to_string_lossy()).is_some())
    }

    /// The same for one frame of many: `%03d` in the name becomes the number, with so many digits at least; without it, the
    /// number stands before the ending, with the digits that the animation gives it.
    pub fn numbered(&self, frame: u32, digits: usize) -> Self {
        let Place::File(path) = &self.place else {
            return self.clone();
        };
        let whole = path.file_name().unwrap_or_default().to_string_lossy();
        let name = if let Some((place, least)) = pattern(&whole) {
            format!("{}{frame:0least$}{}", &whole[..place.start], &whole[place.end..]).into()
        } else {
            let mut name = path.file_stem().unwrap_or_default().to_os_string();
            name.push(format!("{frame:0digits$}"));
            if let Some(ending) = path.extension() {
                name.push(".");
                name.push(ending);
            }
            name
        };
        Self { place: Place::File(path.with_file_name(name)), encoding: self.encoding }
    }

    /// E0004 if it can't be written.
    pub fn check(&self) -> Result<()> {
        match &self.place {
            Place::File(path) => {
                Ok(Disk.check_writable(path).map_err(|e| file::unwritable(&Disk, path, &e)).map_err(Box::new)?)
            }
            _ => Ok(()),
        }
    }

    /// What the bytes of the picture are written to until all are there; nothing if they go nowhere.
    pub fn draft(&self) -> Result<Option<Draft>> {
        Ok(match &self.place {
            Place::Nowhere => None,
            Place::Stdout => Some(Draft::in_memory(Path::new("-"))),
            Place::File(path) => Some(Disk.draft(path).map_err(|e| Box::new(file::unwritable(&Disk, path, &e)))?),
        })
    }

    /// What a picture of this size is drawn on.
    pub fn canvas<'d>(&'d self, draft: Option<&'d mut Draft>, size: Size) -> Result<Canvas<'d>> {
        let path = self.file().unwrap_or(Path::new("standard output"));
        let unwritable = |e: &std::io::Error| file::unwritable(&Disk, path, e);
        Ok(Canvas::new(draft, (size.width, size.height), &self.encoding, unwritable)?)
    }

    /// Puts the file where it belongs, whole or not at all; returns where.
    pub fn place(&self, console: &Console, draft: Option<Draft>) -> Result<Option<&Path>> {
        match (&self.place, draft) {
            (Place::Stdout, Some(draft)) => console.data(draft.into_bytes()).map(|()| None),
            (Place::File(path), Some(draft)) => {
                draft.commit(&Disk).map_err(|e| Box::new(file::unwritable(&Disk, path, &e)))?;
                Ok(Some(path))
            }
            _ => Ok(None),
        }
    }

    /// The bytes of memory that a pixel takes until the file is finished.
    pub fn kept(&self) -> usize {
        if self.place == Place::Nowhere { 0 } else { self.encoding.kept() }
    }
}

/// How the picture is stored.
fn encoding(args: &RenderArgs, format: Format, depth: Option<u8>) -> Encoding {
    let plain = Encoding::new(format);
    Encoding {
        format,
        depth: depth.unwrap_or(plain.depth),
        gray: args.gray,
        alpha: keeps_alpha(&args.look, args),
        gamma: args.file_gamma.map_or(plain.gamma, |gamma| gamma.0),
        dither: args.dither.map(|method| match method {
            DitherMethod::B2 => Dither::Bayer(2),
            DitherMethod::B3 => Dither::Bayer(3),
            DitherMethod::B4 => Dither::Bayer(4),
            DitherMethod::D1 => Dither::Row,
            DitherMethod::D2 => Dither::Simple,
            DitherMethod::Fs => Dither::FloydSteinberg,
        }),
        packing: args.exr_packing.map_or(plain.packing, |packing| match packing {
            ExrPacking::None => Packing::None,
            ExrPacking::Rle => Packing::Runs,
            ExrPacking::Zip => Packing::Zip,
        }),
    }
}

/// What lies outside of `--region` is transparent too.
fn keeps_alpha(look: &LookArgs, args: &RenderArgs) -> bool {
    look.alpha || args.region.is_some()
}

fn is_same(a: &Path, b: &Path) -> bool {
    a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}

/// `%d` or `%03d` in a name, as C and ffmpeg write it: where it stands, and the number of digits.
fn pattern(name: &str) -> Option<(Range<usize>, usize)> {
    name.match_indices('%').find_map(|(at, _)| {
        let digits = name[at + 1..].bytes().take_while(u8::is_ascii_digit).count();
        let end = at + 1 + digits;
        let width = if digits == 0 { Some(1) } else { name[at + 1..end].parse().ok().filter(|width| *width <= 20) };
        width.filter(|_| name[end..].starts_with('d')).map(|width| (at..end + 1, width))
    })
}

/// Is this a folder, there or yet to be made?
pub fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with(std::path::is_separator)
}

/// The input's name with the format's ending, without its folder.
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
        let input = args.inputs[0].clone();
        Target::new(&RenderArgs { input, ..*args })
    }

    fn file(line: &str) -> String {
        match target(line).unwrap().place {
            Place::File(path) => path.display().to_string(),
            other => format!("{other:?}"),
        }
    }

    #[test]
    fn pictures_are_called_by_the_scene_unless_named() {
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
        let numbered = |line: &str, digits| target(line).unwrap().numbered(7, digits).place;
        assert_eq!(numbered("b.scene -o c/d.png", 2), Place::File("c/d07.png".into()));
        assert_eq!(numbered("b.scene -o c/d%03d_.png", 2), Place::File("c/d007_.png".into()));
        assert_eq!(numbered("b.scene -o 100%/%d%%.png", 2), Place::File("100%/7%%.png".into()));
        assert_eq!(numbered("b.scene -o 5%5.png", 1), Place::File("5%57.png".into()));
        assert_eq!(pattern("a%9999999999999999999999d"), None);
    }

    #[test]
    fn what_a_format_lacks_is_refused_early() {
        for line in [
            "-o a.jpg --bit-depth 16",
            "-o a.exr --bit-depth 8",
            "-o a.jpg --alpha",
            "-o a.xyz",
            "-o a",
            "-o a.jpg --size 70000x10",
        ] {
            assert!(target(&format!("b.scene {line}")).is_err(), "{line}");
        }
        assert!(target("b.scene -o - --format ppm --bit-depth 16").is_ok());
        assert!(target("b.scene -o - --format ppm").unwrap().check_many().is_ok());
        assert!(target("b.scene -o -").unwrap().check_many().is_err());
    }
}
