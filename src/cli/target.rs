//! Where pictures go, and as what.

use super::args::{LookArgs, RenderArgs};
use super::console::Console;
use super::exit::{Result, usage};
use crate::diagnostic::file;
use crate::image_io::{Encoding, Format, Frame, encode};
use crate::snapshot;
use crate::source;
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
        let depth = args.bit_depth.as_ref().map(|depth| if depth == "16" { 16 } else { 8 });
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
        if place == Place::Stdout
            && (args.frames.is_some() || args.scene.animation.is_some() && args.scene.frame.is_none())
        {
            return usage("many frames can't go to standard output; name a file");
        }
        Ok(Self {
            place,
            encoding: Encoding { format, depth: depth.unwrap_or(8), alpha: keeps_alpha(&args.look, args) },
        })
    }

    /// Does the picture go to standard output?
    pub fn is_stdout(&self) -> bool {
        self.place == Place::Stdout
    }

    /// The same for one frame of many: the number stands before the ending.
    pub fn numbered(&self, number: &str) -> Self {
        let Place::File(path) = &self.place else {
            return self.clone();
        };
        let mut name = path.file_stem().unwrap_or_default().to_os_string();
        name.push(number);
        if let Some(ending) = path.extension() {
            name.push(".");
            name.push(ending);
        }
        Self { place: Place::File(path.with_file_name(name)), encoding: self.encoding }
    }

    /// E0004 if it can't be written.
    pub fn check(&self) -> Result<()> {
        match &self.place {
            Place::File(path) => {
                Ok(source::check_writable(path).map_err(|e| file::unwritable(path, &e)).map_err(Box::new)?)
            }
            _ => Ok(()),
        }
    }

    /// The bytes of the picture.
    pub fn encode(&self, frame: &Frame) -> Result<Vec<u8>> {
        match self.place {
            Place::Nowhere => Ok(Vec::new()),
            _ => Ok(encode(frame, &self.encoding)?),
        }
    }

    /// Writes them, whole or not at all; returns the file.
    pub fn write(&self, console: &Console, bytes: &[u8]) -> Result<Option<&Path>> {
        match &self.place {
            Place::Nowhere => Ok(None),
            Place::Stdout => console.data(bytes).map(|()| None),
            Place::File(path) => {
                source::write_whole(path, bytes).map_err(|e| Box::new(file::unwritable(path, &e)))?;
                Ok(Some(path))
            }
        }
    }
}

/// What lies outside of `--region` is transparent too.
fn keeps_alpha(look: &LookArgs, args: &RenderArgs) -> bool {
    look.alpha || args.region.is_some()
}

fn is_same(a: &Path, b: &Path) -> bool {
    a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}

fn is_folder(path: &Path) -> bool {
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
        Target::new(&args)
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
        let numbered = target("b.scene -o c/d.png").unwrap().numbered("07");
        assert_eq!(numbered.place, Place::File("c/d07.png".into()));
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
            "-o - --frames 1-3",
        ] {
            assert!(target(&format!("b.scene {line}")).is_err(), "{line}");
        }
        assert!(target("b.scene -o - --format ppm --bit-depth 16").is_ok());
    }
}
