//! `#macro Name(A, B) … #end` and its calls.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::limits::MAX_CALLS;
use crate::interpreter::scope::Slot;
use crate::interpreter::stream::{FrameKind, Token};
use crate::source::Span;
use crate::syntax::ast::*;

/// Macros that call macros are followed so deep to see what they begin with.
const LOOK_DEPTH: usize = 8;

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn define_macro(&mut self, definition: &'a Macro) -> Result<()> {
        self.scopes.set_global(definition.name, Slot::Macro(definition), vec![]);
        Ok(())
    }

    pub(in crate::interpreter) fn is_macro(&self, name: Symbol) -> bool {
        matches!(self.scopes.get(name), Some(Slot::Macro(_)))
    }

    /// Evaluates the arguments, opens a scope and puts the body next in the stream.
    pub(in crate::interpreter) fn call_macro(
        &mut self,
        name: Symbol,
        arguments: &'a [Element],
        span: Span,
    ) -> Result<()> {
        let Some(&Slot::Macro(definition)) = self.scopes.get(name) else { return Ok(()) };
        self.step(span)?;
        if self.depth >= MAX_CALLS {
            let message = format!("`{}` is called {MAX_CALLS} times inside itself", self.names.text(name));
            return self.limit(codes::CALL_DEPTH, span, message, "does this recursion ever end?");
        }
        let mut slots = match self.plain_arguments(definition, arguments)? {
            Some(slots) => slots,
            None => self.enclosed(None, arguments, span, |me| me.arguments(definition, span))?,
        };
        self.scopes.enter();
        for ((parameter, _), slot) in definition.parameters.iter().zip(slots.drain(..)) {
            if let Some(slot) = slot {
                self.scopes.bind_parameter(*parameter, slot);
            }
        }
        self.call_slots = slots;
        self.depth += 1;
        self.push_frame(&definition.body, FrameKind::Macro(name), span);
        Ok(())
    }

    /// Is this a sum whose first term is a macro that gives a block, not a number? In `Boxed(A) -y` the sign then begins
    /// a value of its own, as it would if the macro's text stood there.
    pub(in crate::interpreter) fn leads_with_block(&self, chain: &Chain) -> bool {
        matches!(&chain.first.kind, ExprKind::Call(name, _) if self.gives_block(*name, 0))
            && chain.rest.first().is_some_and(|(op, _)| op.adds())
    }

    fn gives_block(&self, name: Symbol, depth: usize) -> bool {
        let Some(Slot::Macro(definition)) = self.scopes.get(name) else { return false };
        depth < LOOK_DEPTH && self.begins_with_block(&definition.body, depth).unwrap_or(false)
    }

    /// Is the first thing that these elements give a block? `None` if they give nothing.
    fn begins_with_block(&self, elements: &[Element], depth: usize) -> Option<bool> {
        // Between `#declare A =` and its `;` stands what A gets.
        let mut declares = false;
        elements.iter().find_map(|element| match &element.kind {
            ElementKind::Directive(directive) => {
                declares = matches!(**directive, Directive::Declare(_));
                match &**directive {
                    Directive::If(branches) => branches.iter().find_map(|b| self.begins_with_block(&b.body, depth)),
                    _ => None,
                }
            }
            ElementKind::Semicolon => {
                declares = false;
                None
            }
            _ if declares => None,
            ElementKind::Block(_) | ElementKind::Open(_) => Some(true),
            ElementKind::Expr(e) => match e.kind {
                ExprKind::Call(name, _) => Some(self.gives_block(name, depth + 1)),
                _ => Some(false),
            },
            _ => Some(false),
        })
    }

    /// Puts the macro that a sum begins with next in the stream, and behind it the rest of the sum.
    pub(in crate::interpreter) fn call_before_sign(&mut self, chain: &'a Chain, span: Span) -> Result<()> {
        let ExprKind::Call(name, arguments) = &chain.first.kind else { return Ok(()) };
        let key: *const Chain = chain;
        let rest = match self.split_sums.get(&key) {
            Some(rest) => *rest,
            None => {
                let rest = &self.parsed.asts.push_get(Box::new(rest_of_sum(chain))).elements;
                *self.split_sums.entry(key).or_insert(rest)
            }
        };
        self.push_frame(rest, FrameKind::Branch, span);
        self.call_macro(*name, arguments, chain.first.span)
    }

    /// The common case, without a frame: as many expressions as parameters, none of them a macro's or of several values.
    fn plain_arguments(
        &mut self,
        definition: &'a Macro,
        arguments: &'a [Element],
    ) -> Result<Option<Vec<Option<Slot<'a>>>>> {
        let is_plain = |element: &Element| match &element.kind {
            ElementKind::Expr(e) => match &e.kind {
                ExprKind::Name(symbol) => matches!(self.scopes.get(*symbol), Some(Slot::Value(_))),
                ExprKind::Chain(chain) => !self.leads_with_block(chain),
                ExprKind::Number(_) | ExprKind::Paren(_) | ExprKind::Literal(_) | ExprKind::Vector(_) => true,
                ExprKind::Prefix(..) | ExprKind::Builtin(..) | ExprKind::Text(_) => true,
                _ => false,
            },
            _ => false,
        };
        if arguments.len() != definition.parameters.len() || !arguments.iter().all(is_plain) {
            return Ok(None);
        }
        // (A list that was used before: calls are many, and evaluating expressions makes none.)
        let mut slots = std::mem::take(&mut self.call_slots);
        slots.clear();
        for element in arguments {
            let ElementKind::Expr(e) = &element.kind else { return Ok(None) };
            slots.push(Some(match e.kind {
                ExprKind::Name(symbol) => match self.scopes.resolve(symbol) {
                    Some(place) => Slot::Alias(place),
                    None => return Ok(None),
                },
                _ => Slot::Value(self.eval(e)?),
            }));
        }
        Ok(Some(slots))
    }

    fn arguments(&mut self, definition: &'a Macro, span: Span) -> Result<Vec<Option<Slot<'a>>>> {
        let name = self.names.text(definition.name);
        let (depth, wanted) = (self.frames.len(), definition.parameters.len());
        let mut slots = Vec::with_capacity(wanted);
        for &(parameter, optional) in &definition.parameters {
            if matches!(self.peek()?, Token::End) {
                if optional {
                    slots.push(None);
                    continue;
                }
                let parameter = self.names.text(parameter);
                return Diagnostic::new(
                    codes::WRONG_COUNT,
                    span,
                    format!("macro `{name}` takes {}, but only {} given", counted(wanted), are(slots.len())),
                )
                .also(definition.span, "defined here")
                .help(format!("the argument for `{parameter}` is missing"))
                .into();
            }
            slots.push(Some(self.argument(depth)?));
        }
        if !matches!(self.peek()?, Token::End) {
            let message = format!("macro `{name}` takes {}, but more are given", counted(wanted));
            return Diagnostic::new(codes::WRONG_COUNT, self.here(), message)
                .also(definition.span, "defined here")
                .into();
        }
        Ok(slots)
    }

    /// A bare name is passed by reference, all else as a copy; so is a name that a macro gives, which may end with it.
    fn argument(&mut self, depth: usize) -> Result<Slot<'a>> {
        if let Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) = self.peek()?
            && self.frames[depth..].iter().all(|f| !matches!(f.kind, FrameKind::Macro(_) | FrameKind::Include))
            && !self.is_macro(*symbol)
            && let Some(place) = self.scopes.resolve(*symbol)
        {
            self.advance();
            return Ok(Slot::Alias(place));
        }
        if let (Token::Element(_), Some(place)) = (self.peek()?, self.element.clone()) {
            self.take_element()?;
            return Ok(Slot::Alias(place));
        }
        self.rvalue()
    }
}

/// `-b + c` of `a - b + c`.
fn rest_of_sum(chain: &Chain) -> Ast {
    let Some(((sign, term), rest)) = chain.rest.split_first() else { return Ast::default() };
    let prefix = if *sign == Operator::Sub { Prefix::Minus } else { Prefix::Plus };
    let first = Expr { span: term.span, kind: ExprKind::Prefix(prefix, Box::new(term.clone())) };
    let span = rest.iter().fold(term.span, |span, (_, e)| span.to(e.span));
    let kind = match rest {
        [] => first.kind,
        rest => ExprKind::Chain(Box::new(Chain { first, rest: rest.into() })),
    };
    let element = Element { span, kind: ElementKind::Expr(Box::new(Expr { span, kind })) };
    Ast { elements: vec![element], comments: vec![] }
}

fn counted(n: usize) -> String {
    if n == 1 { "one argument".into() } else { format!("{n} arguments") }
}

fn are(n: usize) -> String {
    if n == 1 { "one is".into() } else { format!("{n} are") }
}
