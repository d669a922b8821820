//! The trait through which a family reads its own words. The interpreter implements it, so that
//! directives and macro calls have already run when a family sees what comes next.

use super::{Thing, Unsupported, Value, downcast};
use crate::color::{Color, Gamma};
use crate::diagnostic::{Diagnostic, Result};
use crate::font::Font;
use crate::image_io::Picture;
use crate::math::{DVec2, DVec3, Transform};
use crate::mesh_io::MeshFile;
use crate::source::{Files, Span};
use std::path::PathBuf;
use std::sync::Arc;

/// What comes next, after all directives and macros before it ran.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Next {
    /// A keyword that does not open a block.
    Word(&'static str),
    /// A keyword and its `{`.
    Block(&'static str),
    /// A declared thing of this kind: `texture`, `object` …
    Thing(&'static str),
    /// An expression: number, vector, colour or text.
    Value,
    /// `function { … }`
    Function,
    /// `[`, as in a map's entry.
    Entry,
    /// A `{` without a word in front.
    Group,
    /// The end of the block, entry or file.
    End,
}

impl Next {
    /// Does it begin what [`Reader::transform`] consumes?
    pub fn moves(self) -> bool {
        matches!(
            self,
            Next::Word("translate" | "rotate" | "scale" | "matrix" | "transform")
                | Next::Block("transform")
                | Next::Thing("transform")
        )
    }
}

/// What the file's `#version` and `global_settings` have settled so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Language {
    /// `#version` as 100 times the number: 370 for 3.7. Only `interpreter/compat.rs` compares it.
    pub version: u32,
    /// May a texture hold what belongs into its pigment and finish, as before 3.0?
    pub bare_textures: bool,
    /// `global_settings { assumed_gamma … }`, once it has been read.
    pub assumed_gamma: Option<Gamma>,
    /// What holds without it.
    pub other_gamma: Gamma,
    /// Do picture files that say nothing of their numbers follow the sRGB curve?
    pub srgb_files: bool,
}

/// What [`Reader::float_or_color`] found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FloatOrColor {
    /// A number.
    Float(f64),
    /// A colour.
    Color(Color),
}

/// Something with an inside.
pub trait Solid: std::fmt::Debug + Send + Sync {
    /// Is the point in it?
    fn contains(&self, p: DVec3) -> bool;
}

/// A function, and how many samples of it are wanted across and down.
pub type SizedFunction = ([usize; 2], Arc<dyn Thing>);

/// Makes a shape of a mesh's file. Each of its looks has a picture or none.
pub type BuildMesh = fn(MeshFile, Vec<Option<Arc<Picture>>>) -> Arc<dyn Thing>;

/// A family's view of the text.
///
/// # Errors
/// Each method that reads fails with the place of what is not understood, and what was expected there; faults of directives and macros on
/// the way are among them.
pub trait Reader {
    /// What comes next; nothing is consumed. Commas and semicolons are passed over.
    fn next(&mut self) -> Result<Next>;
    /// The same, but `Next::End` where a directive or a `;` stands before it: is what was just read continued? A directive
    /// may use the name that is just being declared, so it must not run yet.
    fn continued(&mut self) -> Result<Next>;
    /// The place of what comes next.
    fn span(&mut self) -> Span;
    /// Consumes the word or the opening `name {`, `[` or `{` that [`Reader::next`] announced.
    fn take(&mut self) -> Result<Span>;
    /// Consumes the end of the block that was opened; anything else there is an error that names
    /// `what` the block is and which words it takes.
    fn leave(&mut self) -> Result<()>;
    /// Consumes an expression.
    fn value(&mut self) -> Result<(Value, Span)>;
    /// Consumes the declared thing announced by [`Next::Thing`], or the function announced by [`Next::Function`].
    fn take_thing(&mut self) -> Result<(Arc<dyn Thing>, Span)>;
    /// Consumes an object, written out or declared, of which only the inside matters.
    fn solid(&mut self) -> Result<Arc<dyn Solid>>;
    /// Consumes what stands between the braces of a pigment: as a pattern, its brightness.
    fn pigment(&mut self) -> Result<Arc<dyn Thing>>;
    /// A number; a vector is an error.
    fn float(&mut self) -> Result<f64>;
    /// A number if an expression comes next.
    fn optional_float(&mut self) -> Result<Option<f64>>;
    /// Three numbers; a single number stands for all three, as POV-Ray promotes it.
    fn vector(&mut self) -> Result<DVec3>;
    /// Two numbers; a single number stands for both.
    fn vector2(&mut self) -> Result<DVec2>;
    /// Exactly `n` numbers in `< >` (more than five only as a literal, as in `matrix`).
    fn numbers(&mut self, n: usize) -> Result<Vec<f64>>;
    /// Consumes items of a long list of literals all at once, as long as each is a vector of so many numbers that `take` accepts, at most
    /// `most`; returns how many. There may be none, although vectors come next: the first and the last item of a list, and whatever is no
    /// literal, are for the other methods.
    fn literals(&mut self, _width: usize, _most: usize, _take: &mut dyn FnMut(&[f64]) -> bool) -> usize {
        0
    }
    /// `(a, b, …)`: exactly `n` numbers in parentheses.
    fn numbers_in_parentheses(&mut self, n: usize) -> Result<Vec<f64>>;
    /// Consumes a `:`.
    fn colon(&mut self) -> Result<()>;
    /// A colour with all the ways to write one, also without the word `color` or `rgb` before it.
    fn color(&mut self) -> Result<Color>;
    /// A number, or else a colour.
    fn float_or_color(&mut self) -> Result<FloatOrColor>;
    /// Does a colour come next: one of its words, or an expression?
    fn at_color(&mut self) -> Result<bool>;
    /// Consumes one `translate`, `rotate`, `scale`, `matrix`, `transform { … }` or declared transform if one comes next.
    ///
    /// Boxed, because it is large and mostly passed on.
    fn transform(&mut self) -> Result<Option<Box<Transform>>>;
    /// A string.
    fn text(&mut self) -> Result<String>;
    /// `on`, `off`, a number, or nothing at all (which is on).
    fn flag(&mut self) -> Result<bool>;
    /// Version and gamma in force here.
    fn language(&self) -> Language;
    /// Consumes a word or block that is known but not drawn yet, with all that belongs to it, and tells so.
    fn read_unsupported(&mut self, what: &'static str) -> Result<Unsupported>;
    /// Consumes whatever comes next with all that is in it, and keeps it behind what was said before.
    fn pass(&mut self, row: &mut Vec<Unsupported>) -> Result<()>;
    /// The file of this name where scenes look for theirs, if it is there and may be read; `at` is the name's place.
    fn find_file(&mut self, name: &str, at: Span) -> Result<Option<PathBuf>>;
    /// The storage that the scene may read from.
    fn files(&self) -> &dyn Files;
    /// The font of this name, whose place is `at`, or one that looks like it, which is told.
    fn font(&mut self, name: &str, at: Span) -> Result<Arc<Font>>;
    /// Consumes a picture file's name, and decodes the file; fails where it is not found or not understood.
    fn picture(&mut self) -> Result<Arc<Picture>>;
    /// Consumes the name of a mesh's file, and reads the file: what `build` makes of it and the pictures of its materials is kept, and handed
    /// out when the scene names the file again.
    fn mesh_file(&mut self, build: BuildMesh) -> Result<Arc<dyn Thing>>;
    /// Consumes `function W, H { … }`, announced by [`Next::Function`]; `None` if it has no size.
    fn sized_function(&mut self) -> Result<Option<SizedFunction>>;
    /// Tells the user something without stopping.
    fn report(&mut self, diagnostic: Diagnostic);
    /// An error about what comes next: "expected …, found …".
    fn unexpected(&mut self, expected: &str) -> Diagnostic;
    /// An error about the word that comes next, which `block` does not take: names the nearest of
    /// the words that it takes, or lists them.
    fn unknown_word(&mut self, block: &str, takes: &[&'static str]) -> Diagnostic;
}

/// What every reader can do by the methods above.
pub trait ReaderExt: Reader {
    /// Consumes the word if it comes next.
    fn accept(&mut self, word: &str) -> Result<bool>;
    /// Consumes a declared thing of this type if one comes next.
    fn thing<T: Thing>(&mut self) -> Result<Option<Arc<T>>>;
}

impl<R: Reader + ?Sized> ReaderExt for R {
    fn accept(&mut self, word: &str) -> Result<bool> {
        match self.next()? {
            Next::Word(w) if w == word => self.take().map(|_| true),
            _ => Ok(false),
        }
    }

    fn thing<T: Thing>(&mut self) -> Result<Option<Arc<T>>> {
        if !matches!(self.next()?, Next::Thing(_)) {
            return Ok(None);
        }
        let (thing, span) = self.take_thing()?;
        match downcast::<T>(&thing) {
            Some(thing) => Ok(Some(thing)),
            None => Diagnostic::err(
                crate::diagnostic::codes::WRONG_TYPE,
                span,
                format!("{} can't stand here", Value::Thing(thing).describe()),
            ),
        }
    }
}
