//! Reads `translate`, `rotate`, `scale`, `matrix` and `transform { … }`.

use super::super::Interpreter;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec3, Transform};
use crate::scene::is_object;
use crate::source::Span;
use crate::value::{Next, Reader, ReaderExt, Thing};

/// A transform that the scene declared under a name.
#[derive(Debug)]
pub struct TransformThing(pub(in crate::interpreter) Transform);

impl Thing for TransformThing {
    fn kind(&self) -> &'static str {
        "transform"
    }
}

/// Angle in degrees below which `rotate` by a number is likely meant for all axes.
const LARGEST_ANGLE_FOR_ALL_AXES: f64 = 5.0;

impl Interpreter<'_> {
    /// Reads the arguments of `translate`, `rotate`, `scale` or `matrix`, whose word has been consumed.
    fn read_transform_step(&mut self, word: &str) -> Result<Box<Transform>> {
        let span = {
            self.peek()?;
            self.stream.next_span()
        };
        let singular = |_| {
            let d = Diagnostic::new(codes::SINGULAR, span, format!("this `{word}` flattens space"));
            Box::new(d.help("a factor of 0 has no inverse; use a small number instead"))
        };
        Ok(Box::new(match word {
            "translate" => Transform::translate(self.vector()?),
            "rotate" => {
                let angles = self.vector()?;
                self.warn_if_rotating_about_all_axes(angles, span);
                Transform::rotate(angles)
            }
            "scale" => {
                let factors = self.vector()?;
                // POV-Ray replaces a factor of 0 by 1, with a warning.
                let mended = DVec3::select(factors.cmpeq(DVec3::ZERO), DVec3::ONE, factors);
                if mended != factors {
                    let message = "a factor of 0 would flatten the object; 1 is used instead";
                    self.reporter.report(Diagnostic::new(codes::ZERO_SCALE, span, message));
                }
                Transform::scale(mended).map_err(singular)?
            }
            _ => {
                let m = self.numbers_in_angle_brackets(12)?;
                let row = |i: usize| DVec3::new(m[3 * i], m[3 * i + 1], m[3 * i + 2]);
                Transform::from_rows([row(0), row(1), row(2), row(3)]).map_err(singular)?
            }
        }))
    }

    /// Reports the warning W0407 for `rotate 45`, which rotates around all axes. Computed angles, as from `rand`, and
    /// arguments of macros are likely intended.
    fn warn_if_rotating_about_all_axes(&mut self, angles: DVec3, span: Span) {
        if angles.x.abs() < LARGEST_ANGLE_FOR_ALL_AXES || angles.x != angles.y || angles.y != angles.z {
            return;
        }
        // A pattern may be rotated around any axis, to look less regular.
        let word = self.stream.innermost_open_bracket().and_then(|opened| opened.word);
        if !word.is_some_and(|word| is_object(word) || word == "camera") {
            return;
        }
        let typed = self.inputs.sources.snippet(span);
        if typed.parse::<f64>().is_ok() && !self.is_followed_by_operator(span) {
            let message = format!("`rotate {typed}` turns around all three axes, by {typed} degrees each");
            let help =
                format!("write `rotate y*{typed}` for the y axis alone, or `rotate <{typed}, {typed}, {typed}>`");
            let d = Diagnostic::new(codes::ALL_AXES, span, message).help(help);
            self.report_here(d);
        }
    }

    /// True if an operator follows the number in the text: the tokens of `360*rand(S)` begin with a number.
    fn is_followed_by_operator(&self, number: Span) -> bool {
        let Some((file, range)) = self.inputs.sources.locate(number) else { return false };
        let rest = self.inputs.sources.text(file).get(range.end..).unwrap_or("");
        rest.trim_start().starts_with(['*', '/', '+', '-', '.'])
    }

    /// Reads the contents of a `transform` block.
    pub fn read_transform_contents(&mut self) -> Result<Transform> {
        let mut all = Transform::IDENTITY;
        loop {
            match Reader::peek_next(self)? {
                Next::End => return Ok(all),
                Next::Word("inverse") => {
                    self.stream.advance();
                    all = all.inverse();
                }
                _ => match self.transform()? {
                    Some(step) => all = all.then(&step),
                    None => {
                        let words = ["translate", "rotate", "scale", "matrix", "transform", "inverse"];
                        return Err(self.unknown_word("transform", &words).into());
                    }
                },
            }
        }
    }

    /// Reads one transform; `None` if the next token begins none.
    pub(super) fn read_transform(&mut self) -> Result<Option<Box<Transform>>> {
        match Reader::peek_next(self)? {
            Next::Word(word @ ("translate" | "rotate" | "scale" | "matrix")) => {
                self.stream.advance();
                self.read_transform_step(word).map(Some)
            }
            Next::Word("transform") => {
                // `transform T`, as in old scenes.
                self.stream.advance();
                let declared = ReaderExt::take_declared::<TransformThing>(self)?;
                declared.map(|t| Some(Box::new(t.0))).ok_or_else(|| Box::new(self.unexpected_token("a transform")))
            }
            Next::Block("transform") => {
                self.take_token()?;
                let all = self.read_transform_contents()?;
                self.leave_block()?;
                Ok(Some(Box::new(all)))
            }
            Next::Thing("transform") => Ok(ReaderExt::take_declared::<TransformThing>(self)?.map(|t| Box::new(t.0))),
            _ => Ok(None),
        }
    }
}
