//! The trait through which a family of blocks reads its words. The interpreter implements it, so that directives and
//! macro calls before a token have run.

use super::{Spec, Thing, Value, downcast};
use crate::color::{Color, Gamma};
use crate::diagnostic::{Diagnostic, Fault, Result};
use crate::font::Font;
use crate::image_io::Picture;
use crate::math::{DVec2, DVec3, Transform};
use crate::mesh_io::MeshFile;
use crate::source::{Files, Span};
use std::path::PathBuf;
use std::sync::Arc;

/// Kind of the next token of the scene; directives and macro calls before it have run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Next {
    /// Next token is a keyword without a `{`.
    Word(&'static str),
    /// Next tokens are a keyword and its `{`.
    Block(&'static str),
    /// Next token is the name of a declared thing, with the word of its block: `texture`, `object` …
    Thing(&'static str),
    /// Next token begins an expression: number, vector, colour or string.
    Value,
    /// Next tokens begin a function definition, `function { … }`.
    Function,
    /// Next token is a `[`, as in a map's entry.
    Entry,
    /// Next token is a `{` without a word before it.
    Group,
    /// Next comes the end of the block, entry or file.
    End,
}

impl Next {
    /// True if the token begins a transform, which [`Reader::transform`] consumes.
    pub fn is_transform(self) -> bool {
        matches!(
            self,
            Next::Word("translate" | "rotate" | "scale" | "matrix" | "transform")
                | Next::Block("transform")
                | Next::Thing("transform")
        )
    }
}

/// Language version and gamma in force at a point of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Language {
    /// Number of `#version` times 100: 370 for 3.7. Only `interpreter/scene_builder/compat.rs` compares it.
    pub version: u32,
    /// True if a texture may hold the words of its pigment and finish, as before 3.0.
    pub bare_textures: bool,
    /// True if media are sampled by method 1 unless they state a method, as before 3.5.
    pub random_media: bool,
    /// True if the `filter` of a texture's layer transmits light untinted where another layer is below.
    pub untinted_layers: bool,
    /// True if each word of a camera takes effect where it is written, as before 3.5 (quirk: `camera_words_in_order`).
    pub ordered_cameras: bool,
    /// True if operators are allowed outside of parentheses.
    pub bare_operators: bool,
    /// Value of `assumed_gamma`; `None` before `global_settings` has set it.
    pub assumed_gamma: Option<Gamma>,
    /// Working gamma of scenes without `assumed_gamma`.
    pub other_gamma: Gamma,
    /// True if picture files without gamma information are read as sRGB.
    pub srgb_files: bool,
}

/// Result of [`Reader::float_or_color`]: a number or a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FloatOrColor {
    /// Number, where the scene may give a number or a colour.
    Float(f64),
    /// Colour, where the scene may give a number or a colour.
    Color(Color),
}

/// Interface of an object with an inside, such as a sphere.
pub trait Solid: std::fmt::Debug + Send + Sync {
    /// True if the point is inside of the object.
    fn contains(&self, p: DVec3) -> bool;
}

/// Function that fills a picture, with the picture's width and height in pixels.
pub type SizedFunction = ([usize; 2], Arc<dyn Thing>);

/// Function that builds a shape from a mesh file and the pictures of its materials; `None` for a material without a
/// picture.
pub type BuildMesh = fn(MeshFile, Vec<Option<Arc<Picture>>>) -> Arc<dyn Thing>;

/// Reader of a block's contents.
///
/// # Errors
/// Methods that read return a diagnostic at an unexpected token, or one for a fault in a directive or macro before the
/// token.
pub trait Reader {
    /// Returns the kind of the scene's next token, which is not consumed. Commas and semicolons are skipped.
    fn peek_next(&mut self) -> Result<Next>;
    /// Returns the kind of the next token, which is not consumed, or `Next::End` if a comma or a `;` precedes it. In a
    /// declaration, a directive gives `Next::End` too and does not run yet, because it may use the name that is being
    /// declared.
    fn peek_next_unless_separated(&mut self) -> Result<Next>;
    /// Returns the span of the next token in the scene.
    fn span(&mut self) -> Span;
    /// Consumes the word, or the opening `name {`, `[` or `{`, that [`Reader::peek_next`] returned. Returns the span of
    /// the word or bracket.
    fn take_token(&mut self) -> Result<Span>;
    /// Consumes the end of the block; any other token is an error.
    fn leave_block(&mut self) -> Result<()>;
    /// Reads an expression of the scene to its value, which is not checked: it may be a declared thing.
    fn value(&mut self) -> Result<(Value, Span)>;
    /// Consumes the declared thing announced by [`Next::Thing`], or the function announced by [`Next::Function`].
    fn take_thing(&mut self) -> Result<(Arc<dyn Thing>, Span)>;
    /// Reads an object, of which only the inside is used.
    fn read_solid(&mut self) -> Result<Arc<dyn Solid>>;
    /// Reads the inside of a pigment as a pattern: the pigment's brightness.
    fn read_pigment_pattern(&mut self) -> Result<Arc<dyn Thing>>;
    /// Reads a finite number; any other value is an error.
    fn float(&mut self) -> Result<f64>;
    /// Reads a finite number, if an expression comes next; `None` if none does.
    fn optional_float(&mut self) -> Result<Option<f64>>;
    /// Reads a finite vector of at most three components: a number fills all three, and a vector of two gets 0 as
    /// third.
    fn vector(&mut self) -> Result<DVec3>;
    /// Reads a vector of three components, which may be infinite or NaN; a number fills all three.
    fn unchecked_vector(&mut self) -> Result<DVec3>;
    /// Reads a finite vector of two components; a number fills both, and a third component is dropped.
    fn vector2(&mut self) -> Result<DVec2>;
    /// Reads exactly `n` numbers in `< >`; more than five only as a literal, as in `matrix`.
    fn numbers_in_angle_brackets(&mut self, n: usize) -> Result<Vec<f64>>;
    /// Consumes up to `most` items of the scene's literal list, while each is a vector of `width` components that
    /// `take` accepts; returns the number consumed. The result can be 0 although vectors come next: the other methods
    /// read the first and last item of a list, and anything that is not a literal.
    fn read_literals(&mut self, _width: usize, _most: usize, _take: &mut dyn FnMut(&[f64]) -> bool) -> usize {
        0
    }
    /// Reads exactly `n` numbers in parentheses.
    fn numbers_in_parentheses(&mut self, n: usize) -> Result<Vec<f64>>;
    /// Consumes a `:` in the scene.
    fn read_colon(&mut self) -> Result<()>;
    /// Reads a colour, with or without the word `color` or `rgb` before it.
    fn color(&mut self) -> Result<Color>;
    /// Reads a number or a colour.
    fn float_or_color(&mut self) -> Result<FloatOrColor>;
    /// True if a colour can come next: one of its words, or an expression.
    fn may_be_at_color(&mut self) -> Result<bool>;
    /// Reads one `translate`, `rotate`, `scale`, `matrix`, `transform { … }` or declared transform; `None` if another
    /// token comes next.
    ///
    /// Boxed, because a transform is large and mostly passed on.
    fn transform(&mut self) -> Result<Option<Box<Transform>>>;
    /// Reads a string expression of the scene.
    fn text(&mut self) -> Result<String>;
    /// Reads a switch of the scene: `on`, `off` or a number; true if none comes next.
    fn flag(&mut self) -> Result<bool>;
    /// Returns the language version and gamma in force.
    fn language(&self) -> Language;
    /// Reads the next token with its contents, without effect. Directives run and values are evaluated.
    fn skip_item(&mut self) -> Result<()>;
    /// Finds a file in the folders that a scene searches. Returns `None` without a message if the file does not exist,
    /// and an error if the scene may not read it. `at` is the span of the name.
    fn find_file(&mut self, name: &str, at: Span) -> Result<Option<PathBuf>>;
    /// Returns the file storage that the scene may read.
    fn files(&self) -> &dyn Files;
    /// Finds a font; a font with a similar design or durer's own font replaces a missing one, with a warning. Returns an
    /// error for a file that the scene may not read, or that is no font. `at` is the span of the name.
    fn find_font_or_substitute(&mut self, name: &str, at: Span) -> Result<Arc<Font>>;
    /// Finds and decodes a picture file. `format` is the word before the name, such as `jpeg`, whose endings complete a
    /// name without one. `at` is the span of the name.
    fn open_picture(&mut self, name: &str, at: Span, format: Option<&str>) -> Result<Arc<Picture>>;
    /// Reads the name of a mesh file, and builds its shape with `build`. Each file is read once per run.
    fn read_mesh_file(&mut self, build: BuildMesh) -> Result<Arc<dyn Thing>>;
    /// Reads `function W, H { … }`, announced by [`Next::Function`]; consumes nothing and returns `None` if it has no
    /// size.
    fn read_function_if_sized(&mut self) -> Result<Option<SizedFunction>>;
    /// Reports a diagnostic about the scene, and continues reading.
    fn report(&mut self, diagnostic: Diagnostic);
    /// Returns the error "expected …, found …" about the scene's next token.
    fn unexpected(&mut self, expected: &str) -> Diagnostic;
    /// Returns the error for the next word, which `block` does not take: suggests the nearest of the words in `takes`,
    /// or lists them.
    fn unknown_word(&mut self, block: &str, takes: &[&'static str]) -> Diagnostic;
}

/// Methods of every reader, built from those of [`Reader`].
pub trait ReaderExt: Reader {
    /// Consumes the scene's next word if it equals `word`; returns true if so.
    fn accept(&mut self, word: &str) -> Result<bool>;
    /// Consumes a declared thing of type `T`, such as the name of a pigment, and returns it; `None` if no declared
    /// thing comes next, also for a block such as `pigment { … }`.
    ///
    /// # Errors
    /// E0200 for a declared thing of another type.
    fn take_declared<T: Thing>(&mut self) -> Result<Option<Arc<T>>>;
    /// Returns the error for the next word, which the block does not take; see [`Reader::unknown_word`].
    fn unknown_word_in(&mut self, block: &Spec) -> Fault;
}

impl<R: Reader + ?Sized> ReaderExt for R {
    fn accept(&mut self, word: &str) -> Result<bool> {
        match self.peek_next()? {
            Next::Word(w) if w == word => self.take_token().map(|_| true),
            _ => Ok(false),
        }
    }

    fn take_declared<T: Thing>(&mut self) -> Result<Option<Arc<T>>> {
        if !matches!(self.peek_next()?, Next::Thing(_)) {
            return Ok(None);
        }
        let (thing, span) = self.take_thing()?;
        match downcast::<T>(&thing) {
            Some(thing) => Ok(Some(thing)),
            None => Diagnostic::err(
                crate::diagnostic::codes::WRONG_TYPE,
                span,
                format!("{} is not allowed here", Value::Thing(thing).describe()),
            ),
        }
    }

    fn unknown_word_in(&mut self, block: &Spec) -> Fault {
        self.unknown_word(block.name, &block.word_names()).into()
    }
}
