//! What is open at a place in the text: brackets, vectors, choices, directives.
//!
//! A directive's body may leave a brace open that another closes; everything else must be closed where it was opened.

/// The deepest nesting that is read: the parser recurses on the native stack.
pub(super) const MAX_DEPTH: usize = 1000;

/// What was opened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Opener {
    Brace,
    /// That of `function { … }`, inside which `<` compares.
    FunctionBrace,
    Paren,
    Bracket,
    /// `<` of a vector.
    Angle,
    /// `?` of a choice, which ends with whatever is around it.
    Choice,
    /// `#if` and its kin.
    Directive,
}

impl Opener {
    /// What closes it.
    pub(super) fn closer(self) -> &'static str {
        match self {
            Opener::Brace | Opener::FunctionBrace => "}",
            Opener::Paren | Opener::Choice => ")",
            Opener::Bracket => "]",
            Opener::Angle => ">",
            Opener::Directive => "#end",
        }
    }

    fn is_closed_by(self, closer: u8) -> bool {
        match self {
            Opener::Brace | Opener::FunctionBrace => closer == b'}',
            Opener::Paren => closer == b')',
            Opener::Bracket => closer == b']',
            _ => false,
        }
    }
}

/// The openers around a place, each with the number of its token.
#[derive(Default)]
pub(super) struct Nesting {
    stack: Vec<(Opener, usize)>,
    functions: usize,
    /// Braces that a directive's body left open.
    loose: usize,
}

impl Nesting {
    pub(super) fn open(&mut self, opener: Opener, token: usize) {
        self.functions += usize::from(opener == Opener::FunctionBrace);
        self.stack.push((opener, token));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.stack.is_empty()
    }

    pub(super) fn too_deep(&self) -> bool {
        self.stack.len() > MAX_DEPTH
    }

    pub(super) fn in_function(&self) -> bool {
        self.functions > 0
    }

    /// May a list of literals stand here? Between elements, but not inside vectors, parentheses and functions.
    pub(super) fn takes_lists(&self) -> bool {
        !self.in_function() && self.stack.last().is_none_or(|(top, _)| matches!(top, Opener::Brace | Opener::Directive))
    }

    fn pop(&mut self) {
        if let Some((Opener::FunctionBrace, _)) = self.stack.pop() {
            self.functions -= 1;
        }
    }

    /// `>`: the end of a vector, or a comparison.
    pub(super) fn close_angle(&mut self) {
        if matches!(self.stack.last(), Some((Opener::Angle, _))) {
            self.pop();
        }
    }

    /// A closing bracket: true where it closes the innermost bracket, false where it closes one that another directive's body
    /// left open, and an error with the bracket that is open instead, if any.
    pub(super) fn close(&mut self, closer: u8) -> Result<bool, Option<(Opener, usize)>> {
        while matches!(self.stack.last(), Some((Opener::Angle | Opener::Choice, _))) {
            self.pop();
        }
        match self.stack.last() {
            Some((top, _)) if top.is_closed_by(closer) => {
                self.pop();
                Ok(true)
            }
            Some((Opener::Directive, _)) => Ok(false),
            None if closer == b'}' && self.loose > 0 => {
                self.loose -= 1;
                Ok(false)
            }
            other => {
                let opener = other.copied();
                self.pop();
                Err(opener)
            }
        }
    }

    /// `#else`, `#end` and their kin: the tokens that its directive's body leaves open; `None` if there is no directive.
    pub(super) fn back_to_directive(&mut self, end: bool) -> Option<Vec<usize>> {
        let depth = self.stack.iter().rposition(|(opener, _)| *opener == Opener::Directive)?;
        let is_loose = |o: &(Opener, usize)| matches!(o.0, Opener::Brace | Opener::Paren);
        let loose: Vec<usize> = self.stack[depth + 1..].iter().filter(|o| is_loose(o)).map(|o| o.1).collect();
        self.loose += loose.len();
        while self.stack.len() > depth + usize::from(!end) {
            self.pop();
        }
        Some(loose)
    }

    /// What the end of the text leaves open.
    pub(super) fn unclosed(&self) -> Vec<(Opener, usize)> {
        let counts = |o: &&(Opener, usize)| !matches!(o.0, Opener::Choice | Opener::Angle);
        self.stack.iter().filter(counts).copied().collect()
    }
}
