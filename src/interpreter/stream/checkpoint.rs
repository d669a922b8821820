//! Checkpoints: states of the token stream to which reading returns after an error.

use super::bracket::Unclosed;
use super::{Mode, OpenBracket, StackFrame, TokenStream};
use crate::syntax::ast::*;

/// A saved state of the token stream.
#[derive(Clone, Copy)]
pub struct Checkpoint {
    frame_count: usize,
    bracket_count: usize,
    /// Read position in the innermost frame at the time of the checkpoint.
    at: usize,
    mode: Mode,
}

impl Checkpoint {
    /// Returns the number of frames at the time of the checkpoint.
    pub fn frame_count(self) -> usize {
        self.frame_count
    }
}

impl StackFrame<'_> {
    /// Moves to the end of the statement that began at index `from`, in which `open` brackets are open.
    fn skip_statement(&mut self, from: usize, open: Unclosed) {
        self.item = (0, 0);
        self.closer = None;
        if open.count > 0 {
            return self.skip_brackets(open);
        }
        if self.at == from {
            self.skip_element_or_bracket();
        }
        // A block or a function ends a statement. At the start of a loop's next pass there is no last element.
        let last = self.at.checked_sub(1).and_then(|last| self.elements.get(last)).map(|e| &e.kind);
        let ends = matches!(
            last,
            Some(
                ElementKind::Block(_)
                    | ElementKind::Function(_)
                    | ElementKind::Group(_)
                    | ElementKind::Punctuation(Punctuation::Close(Bracket::Brace))
            )
        );
        if ends {
            return;
        }
        while let Some(element) = self.elements.get(self.at) {
            match element.kind {
                ElementKind::Block(_) | ElementKind::Directive(_) => return,
                ElementKind::Word(_) if self.opens_brace(self.at + 1) => return,
                ElementKind::Semicolon => {
                    self.at += 1;
                    return;
                }
                _ => self.skip_element_or_bracket(),
            }
        }
    }

    /// Skips one element, or an opening bracket with the elements up to its partner.
    fn skip_element_or_bracket(&mut self) {
        let opens =
            matches!(self.elements.get(self.at).map(|e| &e.kind), Some(ElementKind::Punctuation(Punctuation::Open(_))));
        self.at += 1;
        if opens {
            self.skip_brackets(Unclosed { count: 1, braces: false });
        }
    }

    fn skip_brackets(&mut self, Unclosed { mut count, braces }: Unclosed) {
        while let Some(element) = self.elements.get(self.at) {
            self.at += 1;
            match element.kind {
                ElementKind::Punctuation(Punctuation::Open(bracket)) if !braces || bracket == Bracket::Brace => {
                    count += 1
                }
                ElementKind::Punctuation(Punctuation::Close(bracket)) if !braces || bracket == Bracket::Brace => {
                    count -= 1
                }
                _ => {}
            }
            if count == 0 {
                return;
            }
        }
    }

    /// Skips the layers that follow the first layer of a texture, which begins at index `first_layer`.
    fn skip_following_texture_layers(&mut self, first_layer: usize) {
        let is_texture = |frame: &Self, at: usize| match frame.elements.get(at).map(|e| &e.kind) {
            Some(ElementKind::Block(b)) => b.name.word == Some("texture"),
            Some(ElementKind::Word(word)) => word.name == "texture" && frame.opens_brace(at + 1),
            _ => false,
        };
        if is_texture(self, first_layer) {
            while is_texture(self, self.at) {
                let alone = matches!(self.elements[self.at].kind, ElementKind::Word(_));
                self.at += usize::from(alone);
                self.skip_element_or_bracket();
            }
        }
    }
}

/// Saves and restores checkpoints. `Interpreter::unwind` drops the frames above a checkpoint, with their scopes.
impl TokenStream<'_> {
    /// Saves the present state of the token stream.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            frame_count: self.frames.len(),
            bracket_count: self.open_brackets.len(),
            at: self.frames.last().map_or(0, |f| f.at),
            mode: self.mode,
        }
    }

    /// True if frames were pushed since the checkpoint.
    pub fn has_frames_above(&self, checkpoint: Checkpoint) -> bool {
        self.frames.len() > checkpoint.frame_count
    }

    /// Restores brackets and mode of the checkpoint, and drops all tokens that were read ahead.
    pub fn restore(&mut self, checkpoint: Checkpoint) {
        self.restore_brackets_only(checkpoint);
        self.mode = checkpoint.mode;
    }

    /// Restores the brackets of the checkpoint, and drops all tokens that were read ahead.
    pub fn restore_brackets_only(&mut self, checkpoint: Checkpoint) {
        self.open_brackets.truncate(checkpoint.bracket_count);
        self.pushed_back.clear();
        (self.look_ahead, self.comma) = (None, false);
    }

    /// Skips the statement that began at the checkpoint. `open` are the brackets that were open at the error.
    pub fn skip_statement(&mut self, checkpoint: Checkpoint, open: OpenedBrackets) {
        if let Some(frame) = self.frames.last_mut() {
            frame.skip_statement(checkpoint.at, open.0);
        }
    }

    /// Skips to the end of the brackets that were opened since the checkpoint.
    pub fn skip_brackets(&mut self, open: OpenedBrackets) {
        if let Some(frame) = self.frames.last_mut().filter(|_| open.0.count > 0) {
            frame.skip_brackets(open.0);
        }
    }

    /// Skips the layers that follow the first layer of a declared texture, which begins at the checkpoint.
    pub fn skip_following_texture_layers(&mut self, checkpoint: Checkpoint) {
        if let Some(frame) = self.frames.last_mut() {
            frame.skip_following_texture_layers(checkpoint.at);
        }
    }

    /// Returns the brackets opened since the checkpoint in the frame that was innermost then: only the braces, if there
    /// are any.
    pub fn brackets_opened_since(&self, checkpoint: Checkpoint) -> OpenedBrackets {
        let own = |o: &&OpenBracket| o.alone.is_some() && o.frame_count == checkpoint.frame_count;
        let all = self.open_brackets.iter().skip(checkpoint.bracket_count).filter(own);
        let braces = all.clone().filter(|o| o.bracket == Bracket::Brace).count();
        OpenedBrackets(Unclosed { count: if braces > 0 { braces } else { all.count() }, braces: braces > 0 })
    }
}

/// Brackets opened since a checkpoint; see [`TokenStream::brackets_opened_since`].
#[derive(Clone, Copy)]
pub struct OpenedBrackets(Unclosed);
