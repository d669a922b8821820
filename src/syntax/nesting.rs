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

/// What a closing bracket does.
pub(super) enum Closing {
    /// Closes the innermost bracket.
    Closes,
    /// Closes one that another directive's body opened, or one around this directive.
    Loose,
    /// An error: this one should have been closed before, and the closer is for one further out.
    Unclosed(Opener, usize),
    /// An error: closes this one, which is of another kind.
    Swapped(Opener, usize),
    /// An error: closes nothing; the brace that is open, if any.
    Stray(Option<usize>),
}

/// Braces around a directive that its bodies close.
#[derive(Default)]
struct Closed {
    /// In this body.
    here: usize,
    /// In one of those before.
    most: usize,
}

/// The openers around a place, each with the number of its token.
#[derive(Default)]
pub(super) struct Nesting {
    stack: Vec<(Opener, usize)>,
    /// For each directive on the stack.
    closed: Vec<Closed>,
    functions: usize,
    /// Braces that a directive's body left open.
    loose: usize,
}

impl Nesting {
    pub(super) fn open(&mut self, opener: Opener, token: usize) {
        self.functions += usize::from(opener == Opener::FunctionBrace);
        if opener == Opener::Directive {
            self.closed.push(Closed::default());
        }
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
        match self.stack.pop() {
            Some((Opener::FunctionBrace, _)) => self.functions -= 1,
            Some((Opener::Directive, _)) => drop(self.closed.pop()),
            _ => {}
        }
    }

    /// `>`: the end of a vector, or a comparison.
    pub(super) fn close_angle(&mut self) {
        if matches!(self.stack.last(), Some((Opener::Angle, _))) {
            self.pop();
        }
    }

    /// A closing bracket.
    pub(super) fn close(&mut self, closer: u8) -> Closing {
        let is_bracket = |o: &(Opener, usize)| !matches!(o.0, Opener::Angle | Opener::Choice);
        let innermost = self.stack.last().copied();
        let Some(depth) = self.stack.iter().rposition(is_bracket) else {
            return self.close_without_bracket(innermost, closer);
        };
        let (top, token) = self.stack[depth];
        let matches_further_out = || {
            let rest = self.stack[..depth].iter().rev().take_while(|o| o.0 != Opener::Directive);
            rest.into_iter().any(|o| o.0.is_closed_by(closer))
        };
        if top.is_closed_by(closer) {
            self.pop_to(depth);
            return Closing::Closes;
        }
        match (innermost, top) {
            (Some((Opener::Angle, vector)), _) => {
                self.pop();
                Closing::Swapped(Opener::Angle, vector)
            }
            (_, Opener::Directive) => {
                self.pop_to(depth + 1);
                self.close_in_branch(closer);
                Closing::Loose
            }
            _ if matches_further_out() => {
                self.pop_to(depth);
                Closing::Unclosed(top, token)
            }
            (_, Opener::Brace | Opener::FunctionBrace) => Closing::Stray(Some(token)),
            _ => {
                self.pop_to(depth);
                Closing::Swapped(top, token)
            }
        }
    }

    fn close_without_bracket(&mut self, innermost: Option<(Opener, usize)>, closer: u8) -> Closing {
        match innermost {
            Some((Opener::Angle, vector)) => {
                self.pop();
                Closing::Swapped(Opener::Angle, vector)
            }
            _ if closer == b'}' && self.loose > 0 => {
                self.loose -= 1;
                Closing::Loose
            }
            _ => Closing::Stray(None),
        }
    }

    /// A closer in a directive's body that nothing in there opened.
    fn close_in_branch(&mut self, closer: u8) {
        if closer == b'}'
            && self.loose == 0
            && let Some(closed) = self.closed.last_mut()
        {
            closed.here += 1;
        }
    }

    fn pop_to(&mut self, depth: usize) {
        while self.stack.len() > depth {
            self.pop();
        }
    }

    /// `#else`, `#end` and their kin: the tokens that its directive's body leaves open, and those around it that it
    /// closes; `None` if there is no directive.
    pub(super) fn back_to_directive(&mut self, end: bool) -> Option<Vec<usize>> {
        let depth = self.stack.iter().rposition(|(opener, _)| *opener == Opener::Directive)?;
        let is_loose = |o: &(Opener, usize)| matches!(o.0, Opener::Brace | Opener::Paren);
        let mut loose: Vec<usize> = self.stack[depth + 1..].iter().filter(|o| is_loose(o)).map(|o| o.1).collect();
        self.loose += loose.len();
        self.pop_to(depth + 1);
        let Some(closed) = self.closed.last_mut() else { return Some(loose) };
        closed.most = closed.most.max(closed.here);
        closed.here = 0;
        if end {
            let most = closed.most;
            self.pop();
            self.close_around(most, &mut loose);
        }
        Some(loose)
    }

    /// Braces around a directive that its body closes: they end here.
    fn close_around(&mut self, count: usize, loose: &mut Vec<usize>) {
        for _ in 0..count {
            match (self.stack.last(), self.closed.last_mut()) {
                (Some((Opener::Brace, token)), _) => {
                    loose.push(*token);
                    self.pop();
                }
                (Some((Opener::Directive, _)), Some(closed)) => closed.here += 1,
                _ => {}
            }
        }
    }

    /// What the end of the text leaves open.
    pub(super) fn unclosed(&self) -> Vec<(Opener, usize)> {
        let counts = |o: &&(Opener, usize)| !matches!(o.0, Opener::Choice | Opener::Angle);
        self.stack.iter().filter(counts).copied().collect()
    }
}
