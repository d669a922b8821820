//! Reads statements outside of all blocks: objects, lights, cameras, settings.

use super::stream::Token;
use super::{Interpreter, reporter::hints};
use crate::atmosphere::{Fog, Rainbow, SkySphere};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::medium::Media;
use crate::scene::{Object, is_object, read_camera};
use crate::shape::Shape;
use crate::source::Span;
use crate::syntax::ast::{Element, ElementKind, Operator, Punctuation};
use crate::texture::warn_if_color_in_bytes;
use crate::value::words::word;
use crate::value::{Family, Next, Reader, Spec, ValueKind};

/// Words that begin a statement outside of all blocks, except shapes.
pub const STATEMENTS: Spec = Spec {
    name: "scene",
    summary: "words of a scene outside of all braces",
    words: &[
        word(
            "camera",
            ValueKind::Block,
            "at the origin, along z",
            "viewpoint and projection of the picture; the last one is used",
        ),
        word("light_source", ValueKind::Block, "", "a light"),
        word("union", ValueKind::Block, "", "several objects as one"),
        word("composite", ValueKind::Block, "", "in old scenes: `union`"),
        word("merge", ValueKind::Block, "", "union without the surfaces inside, for glass"),
        word("intersection", ValueKind::Block, "", "the space that several objects share"),
        word("difference", ValueKind::Block, "", "the first object without the others"),
        word("object", ValueKind::Block, "", "a declared or other object, with further words after it"),
        word("background", ValueKind::Color, "black", "colour of rays that hit nothing"),
        word("sky_sphere", ValueKind::Block, "", "the sky: pigments by direction; the last one is used"),
        word("fog", ValueKind::Block, "", "colour that covers distant objects; several fogs add up"),
        word("rainbow", ValueKind::Block, "", "an arc of colours; several rainbows add up"),
        word("media", ValueKind::Block, "", "smoke, dust or haze in the whole scene; several add up"),
        word("light_group", ValueKind::Block, "", "lights that illuminate only the objects of the group"),
        word("global_settings", ValueKind::Block, "", "settings of the whole scene"),
        word("default", ValueKind::Block, "", "after `#`: defaults of the objects that follow"),
        word("declare", ValueKind::Nothing, "", "`#declare` in old scenes that omit the `#`"),
        word("include", ValueKind::Nothing, "", "`#include` in old scenes that omit the `#`"),
        word("max_trace_level", ValueKind::Float, "", "in old scenes: as in `global_settings`"),
    ],
    ignored: &["max_intersections"],
    ..Spec::EMPTY
};

impl Interpreter<'_> {
    /// Reads one statement, whose first token [`Self::peek`] has returned; returns false at the end of the file.
    pub(super) fn read_statement_unless_end(&mut self) -> Result<bool> {
        match Reader::peek_next(self)? {
            Next::End if !matches!(self.peek()?, Token::End) => {
                let span = self.stream.next_span();
                self.stream.advance();
                let message = format!("`{}` closes nothing", self.inputs.sources.snippet(span));
                let d = Diagnostic::new(codes::UNMATCHED_CLOSER, span, message);
                return d.help("remove it, or look for its opener above").into();
            }
            Next::End => return Ok(false),
            Next::Block(word) => self.read_top_block(word)?,
            Next::Word("max_trace_level") => self.read_stray_trace_level()?,
            Next::Word(word @ ("declare" | "include")) => self.run_bare_directive(word)?,
            Next::Value if self.is_at_bare_version() => self.run_bare_directive("version")?,
            Next::Word(word) if STATEMENTS.ignores(word) => {
                self.take_token()?;
                self.float()?;
            }
            Next::Thing("object" | "light_source") => {
                self.read_top_object()?;
            }
            Next::Thing(kind) => {
                let span = self.stream.next_span();
                let d =
                    Diagnostic::new(codes::EXPECTED, span, format!("a {kind} is not allowed at the outermost level"));
                return d.help("only objects do; a `texture` or `pigment` belongs inside one").into();
            }
            Next::Value => return Err(self.stray_value_error().into()),
            _ => return Err(self.unknown_word("scene", &statement_names()).into()),
        }
        Ok(true)
    }

    fn read_top_block(&mut self, word: &'static str) -> Result<()> {
        if is_object(word) {
            return self.read_top_object();
        }
        const OTHERS: [&str; 8] =
            ["camera", "background", "sky_sphere", "fog", "rainbow", "media", "global_settings", "default"];
        if !OTHERS.contains(&word) {
            return Err(self.stray_block_error(word).into());
        }
        let at = self.take_token()?;
        match word {
            "camera" => {
                let defaults = self.builder.defaults().clone();
                let camera = read_camera(self, at, &defaults)?;
                self.builder.set_camera(camera, at);
            }
            "background" => {
                let at = self.span();
                let color = self.color()?;
                warn_if_color_in_bytes(self, at, &color);
                self.builder.set_background(color);
            }
            "sky_sphere" => {
                let defaults = self.builder.defaults().clone();
                let sky = SkySphere::read(self, &defaults.texture, at)?;
                self.builder.set_sky_sphere(sky);
            }
            "fog" => {
                let fog = Fog::read(self)?;
                self.builder.add_fog(fog);
            }
            "rainbow" => {
                let rainbow = Rainbow::read(self, at)?;
                self.builder.add_rainbow(rainbow);
            }
            "media" => {
                let media = Media::read(self, at)?;
                self.builder.add_media(media);
            }
            "default" => self.read_defaults()?,
            _ => {
                let mut settings = self.builder.settings().clone();
                settings.read(self)?;
                self.builder.set_settings(settings);
            }
        }
        self.leave_block()
    }

    fn read_top_object(&mut self) -> Result<()> {
        let defaults = self.builder.defaults().clone();
        let object = Object::read(self, &defaults)?;
        self.builder.add_object(*object);
        if self.inputs.options.record_origins {
            self.builder.add_object_call_trace(self.stream.call_trace());
        }
        Ok(())
    }

    /// Runs a directive without its `#`, which POV-Ray accepts for some directives between statements.
    fn run_bare_directive(&mut self, word: &'static str) -> Result<()> {
        let span = self.stream.next_span();
        self.stream.advance();
        let d = Diagnostic::new(codes::MISPLACED, span, format!("`{word}` is missing its `#`"));
        self.report_here(d.help(format!("write `#{word}`")));
        match crate::interpreter::directives::find_runner(word) {
            Some((name, run)) => self.run_directive_function(name, run, span),
            None => self.run_declare_by_tokens(false, span),
        }
    }

    fn is_at_bare_version(&self) -> bool {
        self.stream.next_raw_element().is_some_and(|element| self.inputs.sources.snippet(element.span) == "version")
    }

    /// Reads `max_trace_level`, which POV-Ray also accepts outside of `global_settings`.
    fn read_stray_trace_level(&mut self) -> Result<()> {
        let at = self.stream.next_span();
        let mut settings = self.builder.settings().clone();
        self.take_token()?;
        let read = settings.read_max_trace_level(self);
        self.builder.set_settings(settings);
        read?;
        let d = Diagnostic::new(codes::MISPLACED, at, "`max_trace_level` is outside of `global_settings`");
        self.report_here(d.help("write `global_settings { max_trace_level … }`"));
        Ok(())
    }

    /// Returns the error for a block outside of all blocks that belongs inside another one.
    fn stray_block_error(&mut self, word: &'static str) -> Diagnostic {
        let span = match self.peek() {
            Ok(Token::Block(name)) => name.span,
            _ => self.stream.next_span(),
        };
        let d = Diagnostic::new(codes::EXPECTED, span, format!("`{word} {{…}}` is not a statement of its own"));
        match hints::block_place_hint(word).or_else(|| hints::other_tool_hint(word)) {
            Some(hint) => d.help(hint),
            None => d.help(format!("it belongs inside another block, or after `#declare Name = {word} {{…}}`")),
        }
    }

    /// Returns the error for a value outside of all blocks, mostly due to a misspelt word or a missing `#declare`.
    fn stray_value_error(&mut self) -> Diagnostic {
        if let Ok(Token::Expr(e)) = self.peek() {
            if let Some(at) = self.comparison_ahead() {
                return self.syntax_error_at(at);
            }
            if let Err(fault) = self.evaluate(e) {
                return *fault;
            }
        }
        let (at, is_value) = match self.peek() {
            Ok(Token::Expr(e)) => (e.span, !self.inputs.sources.snippet(e.span).starts_with('(')),
            Ok(Token::Numbers(_)) => (self.stream.next_span(), true),
            Ok(Token::Punctuation(mark)) => (self.stream.next_span(), self.begins_value(mark, self.stream.next_span())),
            _ => (Span::NONE, false),
        };
        if !is_value {
            return self.unexpected_token("an object or a directive");
        }
        Diagnostic::new(codes::EXPECTED, at, "expected an object or a directive, found a value")
            .help("to give it a name, write `#declare Name = …;`")
    }

    /// True if the mark is a token by itself and begins a value. After an operand, `<` is a comparison.
    fn begins_value(&self, mark: Punctuation, span: Span) -> bool {
        let Some((file, range)) = self.inputs.sources.locate(span) else { return false };
        let (before, behind) = self.inputs.sources.text(file).split_at(range.start);
        let begins = match mark {
            Punctuation::Not => true,
            Punctuation::Operator(Operator::Less) => {
                !before.trim_end().ends_with(|c: char| c.is_alphanumeric() || "_.)]\"".contains(c))
            }
            Punctuation::Operator(op) => op.is_addition_or_subtraction(),
            _ => false,
        };
        let rest = &behind[range.len()..];
        // A `<` without a `>` in the same line is a comparison too.
        let line = rest.split(['\n', '\r', ';']).next().unwrap_or_default();
        let compares = mark == Punctuation::Operator(Operator::Less) && !line.contains('>');
        let operand = rest.trim_start_matches(|c: char| c <= ' ' || "+-!".contains(c));
        begins && !compares && operand.starts_with(|c: char| c.is_alphanumeric() || "_.(<\"".contains(c))
    }

    /// Returns the span of a comparison sign after the next operands, as in `Size = 3`.
    fn comparison_ahead(&mut self) -> Option<Span> {
        if matches!(self.stream.next_raw_element().map(|e| &e.kind), Some(ElementKind::Expr(e)) if e.has_bare_condition())
        {
            self.stream.split_next_element();
        }
        let row = self.stream.innermost()?.unread().iter();
        let in_row =
            |e: &&Element| matches!(e.kind, ElementKind::Expr(_) | ElementKind::Punctuation(Punctuation::Operator(_)));
        let compares = |e: &Element| match e.kind {
            ElementKind::Punctuation(Punctuation::Operator(op)) => {
                !op.is_addition_or_subtraction() && !op.is_multiplication_or_division()
            }
            _ => false,
        };
        row.take_while(in_row).find(|e| compares(e)).map(|e| e.span)
    }

    /// Sets the properties that depend on the whole text, closes open files, and warns about a scene without a camera.
    pub(super) fn finish_scene(&mut self) {
        self.close_files();
        self.builder.set_final_version_properties();
        if !self.builder.has_camera() && self.reporter.error_count() == 0 {
            let message = "the scene has no camera: the default one at <0, 0, 0> looks along z";
            self.reporter.report(
                Diagnostic::new(codes::NO_CAMERA, Span::NONE, message)
                    .help("`camera { location <0, 2, -5> look_at 0 }`"),
            );
        }
    }
}

fn statement_names() -> Vec<&'static str> {
    STATEMENTS.word_names().into_iter().chain(Shape::SPECS.iter().map(|s| s.name)).collect()
}
