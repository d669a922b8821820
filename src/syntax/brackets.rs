//! Matching of brackets: a stack of the brackets that are open at a position of the text.
//!
//! Brackets match within one directive's body. A bracket without a partner in the same body is not an error: the
//! partner may come from a macro, another branch or another file. The grammar makes such a bracket an element by
//! itself.

use super::class;

/// Maximum nesting depth of brackets, because the parser recurses on the native stack.
pub(super) const MAX_DEPTH: usize = 1000;

/// Opening bracket or directive that needs a matching end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Opener {
    Brace,
    /// Opening brace of `function { … }`, inside which `<` compares.
    FunctionBrace,
    /// Opening parenthesis of a group, a condition or a built-in function's arguments, inside which `<` compares.
    Paren,
    /// Opening parenthesis of the arguments of a macro or of an author's function.
    Arguments,
    Bracket,
    /// The `<` that opens a vector.
    Angle,
    /// The `?` that opens a conditional expression.
    Choice,
    /// The `:` of a conditional expression, whose last operand extends to the next comma or bracket.
    Otherwise,
    /// Directive with a body, by its token class.
    Directive(u8),
}

impl Opener {
    /// Returns the token classes of a matched opening and closing bracket.
    pub(super) fn opening_and_closing_class(self) -> (u8, u8) {
        match self {
            Opener::Brace | Opener::FunctionBrace => (class::BRACE, class::BRACE_END),
            Opener::Paren | Opener::Arguments => (class::PAREN, class::PAREN_END),
            Opener::Bracket => (class::BRACKET, class::BRACKET_END),
            Opener::Angle => (class::VECTOR, class::VECTOR_END),
            Opener::Choice => (class::CHOICE, class::CHOICE_ELSE),
            Opener::Otherwise => (class::CHOICE_ELSE, class::SEMICOLON),
            Opener::Directive(class) => (class, class::END),
        }
    }

    /// True for `?`, its `:` and the `<` of a vector, which end together with the bracket around them.
    fn is_closed_by_outer(self) -> bool {
        matches!(self, Opener::Angle | Opener::Choice | Opener::Otherwise)
    }
}

/// Stack of the brackets and directives that are open at a position, each with the index of its token.
#[derive(Default)]
pub(super) struct Brackets {
    stack: Vec<(Opener, usize)>,
    functions: usize,
}

impl Brackets {
    pub(super) fn open(&mut self, opener: Opener, token: usize) {
        self.functions += usize::from(opener == Opener::FunctionBrace);
        self.stack.push((opener, token));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.stack.is_empty()
    }

    pub(super) fn is_too_deep(&self) -> bool {
        self.stack.len() > MAX_DEPTH
    }

    pub(super) fn is_in_function(&self) -> bool {
        self.functions > 0
    }

    /// True if a `<` after an operand is a comparison at the present position.
    pub(super) fn less_sign_compares(&self) -> bool {
        let open = self.stack.iter().rev().map(|o| o.0);
        let around = open
            .take_while(|o| *o != Opener::Angle)
            .find(|o| !matches!(o, Opener::Directive(_) | Opener::Choice | Opener::Otherwise));
        self.is_in_function() || around == Some(Opener::Paren)
    }

    /// True if a list of literals is allowed at the present position: between elements, but not inside vectors,
    /// parentheses and functions.
    pub(super) fn allows_number_lists(&self) -> bool {
        let top = self.stack.last().map(|o| o.0);
        !self.is_in_function() && matches!(top, None | Some(Opener::Brace | Opener::Directive(_)))
    }

    fn pop(&mut self) {
        if let Some((Opener::FunctionBrace, _)) = self.stack.pop() {
            self.functions -= 1;
        }
    }

    fn pop_to(&mut self, depth: usize) {
        while self.stack.len() > depth {
            self.pop();
        }
    }

    /// Closes the innermost bracket that matches the class `closer`, and returns the bracket and its token index.
    /// Brackets inside it stay unmatched. `None` if no bracket in the same body matches; then nothing is closed.
    pub(super) fn close_and_opener_token(&mut self, closer: u8) -> Option<(Opener, usize)> {
        let body = self.stack.iter().rposition(|o| matches!(o.0, Opener::Directive(_))).map_or(0, |i| i + 1);
        let weak = matches!(closer, class::VECTOR_END | class::CHOICE_ELSE);
        let own = self.stack[body..].iter().rev();
        // A `>` or `:` does not match beyond brackets.
        let passed = |o: Opener| !weak || matches!(o, Opener::Choice | Opener::Otherwise);
        let skipped = own.take_while(|o| o.0.opening_and_closing_class().1 != closer && passed(o.0)).count();
        let depth = self.stack.len() - skipped;
        if depth == body || self.stack[depth - 1].0.opening_and_closing_class().1 != closer {
            return None;
        }
        let found = self.stack[depth - 1];
        self.pop_to(depth - 1);
        if found.0 == Opener::Choice {
            self.open(Opener::Otherwise, found.1);
        }
        Some(found)
    }

    /// Ends conditional expressions at a comma or semicolon.
    pub(super) fn end_conditional_expressions(&mut self) {
        while matches!(self.stack.last(), Some((Opener::Otherwise, _))) {
            self.pop();
        }
    }

    /// Ends the present body of the innermost directive, at `#else` or `#end`, and returns the directive's class. The
    /// directive stays open. `None` if no directive is open.
    pub(super) fn end_body_and_class(&mut self) -> Option<u8> {
        let depth = self.stack.iter().rposition(|o| matches!(o.0, Opener::Directive(_)))?;
        self.pop_to(depth + 1);
        match self.stack[depth].0 {
            Opener::Directive(class) => Some(class),
            _ => None,
        }
    }

    /// Removes the innermost open directive, at `#end`.
    pub(super) fn close_directive(&mut self) {
        self.pop();
    }

    /// Returns the number of directives that have no `#end` yet.
    pub(super) fn n_open_directives(&self) -> usize {
        self.stack.iter().filter(|o| matches!(o.0, Opener::Directive(_))).count()
    }

    /// Returns the token indices of those open brackets that were opened before the outermost open directive.
    pub(super) fn bracket_tokens_outside_directives(&self) -> impl Iterator<Item = usize> + '_ {
        let outermost = self.stack.iter().take_while(|o| !matches!(o.0, Opener::Directive(_)));
        outermost.filter(|o| !o.0.is_closed_by_outer()).map(|o| o.1)
    }
}
