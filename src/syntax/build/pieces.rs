//! Splits expressions into lists of elements, where a macro or text after the expression may change the precedence.

use crate::source::Span;
use crate::syntax::Names;
use crate::syntax::ast::*;
use crate::syntax::word;

/// Returns the parts of an expression, one level down: operators and operands, or brackets and their contents.
pub fn pieces(e: &Expr, names: &Names) -> Vec<Element> {
    let mut out = Pieces(vec![]);
    match &e.kind {
        ExprKind::Paren(inner) => out.bracketed(Bracket::Paren, e.span, |out| out.whole(inner)),
        ExprKind::Vector(parts) => {
            out.punctuation(Punctuation::Operator(Operator::Less), Span { hi: e.span.lo + 1, ..e.span });
            out.0.extend(parts.iter().cloned());
            out.punctuation(Punctuation::Operator(Operator::Greater), Span { lo: e.span.hi - 1, ..e.span });
        }
        ExprKind::Literal(data) => {
            out.punctuation(Punctuation::Operator(Operator::Less), Span { hi: e.span.lo + 1, ..e.span });
            for x in data.iter() {
                out.whole(&Expr { span: e.span, calls: false, kind: ExprKind::Number(*x) });
                out.mark_comma_after_last();
            }
            out.punctuation(Punctuation::Operator(Operator::Greater), Span { lo: e.span.hi - 1, ..e.span });
        }
        ExprKind::Builtin(name, arguments) => {
            let span = Span { hi: e.span.lo + name.name.len() as u32, ..e.span };
            out.0.push(Element::new(span, ElementKind::Word(name)));
            let brackets = Span { lo: span.hi, ..e.span };
            out.bracketed(Bracket::Paren, brackets, |out| {
                for argument in arguments {
                    out.whole(argument);
                    out.mark_comma_after_last();
                }
                out.unmark_comma_after_last();
            });
        }
        ExprKind::Call(symbol, arguments) => {
            let span = Span { hi: e.span.lo + names.text(*symbol).len() as u32, ..e.span };
            out.whole(&Expr { span, calls: false, kind: ExprKind::Name(*symbol) });
            out.arguments(arguments, Span { lo: span.hi, ..e.span });
        }
        ExprKind::Index(base, indices) => {
            out.whole(base);
            for index in indices {
                let span = Span { lo: index.span.lo.saturating_sub(1), hi: index.span.hi + 1 };
                out.bracketed(Bracket::Square, span, |out| out.whole(index));
            }
        }
        ExprKind::Apply(base, arguments) => {
            out.whole(base);
            out.arguments(arguments, Span { lo: base.span.hi, ..e.span });
        }
        ExprKind::Dot(base, name, symbol) => {
            out.whole(base);
            out.punctuation(Punctuation::Dot, Span { lo: base.span.hi, hi: name.span.lo });
            let keyword = name.word.and_then(word::entry).filter(|w| w.category != word::Category::Constant);
            match keyword {
                Some(word) => out.0.push(Element::new(name.span, ElementKind::Word(word))),
                None => out.whole(&Expr { span: name.span, calls: false, kind: ExprKind::Name(*symbol) }),
            }
        }
        _ => out.operands(e),
    }
    out.0
}

/// True if the text of the expression begins with `-` or `+`.
pub fn begins_with_sign(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(x) => x.is_sign_negative(),
        ExprKind::Prefix(prefix, _) => *prefix != Prefix::Not,
        ExprKind::Chain(chain) => begins_with_sign(&chain.first),
        ExprKind::Choice(parts) => begins_with_sign(&parts[0]),
        _ => false,
    }
}

/// True if the text of the expression begins with `(`.
pub fn begins_with_parenthesis(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Paren(_) => true,
        ExprKind::Dot(base, ..) | ExprKind::Index(base, _) | ExprKind::Apply(base, _) => begins_with_parenthesis(base),
        ExprKind::Chain(chain) => begins_with_parenthesis(&chain.first),
        ExprKind::Choice(parts) => begins_with_parenthesis(&parts[0]),
        _ => false,
    }
}

struct Pieces(Vec<Element>);

impl Pieces {
    fn whole(&mut self, e: &Expr) {
        let kind = match &e.kind {
            ExprKind::Block(block) => ElementKind::Block(block.clone()),
            ExprKind::Function(function) => ElementKind::Function(function.clone()),
            _ => ElementKind::Expr(Box::new(e.clone())),
        };
        self.0.push(Element::new(e.span, kind));
    }

    fn punctuation(&mut self, mark: Punctuation, span: Span) {
        self.0.push(Element::new(span, ElementKind::Punctuation(mark)));
    }

    fn mark_comma_after_last(&mut self) {
        self.0.last_mut().into_iter().for_each(|last| last.comma = true);
    }

    fn unmark_comma_after_last(&mut self) {
        self.0.last_mut().into_iter().for_each(|last| last.comma = false);
    }

    fn bracketed(&mut self, bracket: Bracket, span: Span, fill: impl FnOnce(&mut Self)) {
        self.punctuation(Punctuation::Open(bracket), Span { hi: span.lo + 1, ..span });
        fill(self);
        self.punctuation(Punctuation::Close(bracket), Span { lo: span.hi.saturating_sub(1), ..span });
    }

    fn arguments(&mut self, arguments: &[Element], span: Span) {
        self.bracketed(Bracket::Paren, span, |out| out.0.extend(arguments.iter().cloned()));
    }

    /// Appends the operands and operators of a chain, in the order of the text.
    fn operands(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::Chain(chain) => {
                self.operands(&chain.first);
                let mut end = chain.first.span.hi;
                for (op, operand) in &chain.rest {
                    self.punctuation(Punctuation::Operator(*op), Span { lo: end, hi: operand.span.lo });
                    self.operands(operand);
                    end = operand.span.hi;
                }
            }
            ExprKind::Prefix(prefix, inner) => {
                let mark = match prefix {
                    Prefix::Minus => Punctuation::Operator(Operator::Sub),
                    Prefix::Plus => Punctuation::Operator(Operator::Add),
                    Prefix::Not => Punctuation::Not,
                };
                self.punctuation(mark, Span { hi: e.span.lo + 1, ..e.span });
                self.operands(inner);
            }
            ExprKind::Number(x) if x.is_sign_negative() => {
                self.punctuation(Punctuation::Operator(Operator::Sub), Span { hi: e.span.lo + 1, ..e.span });
                let span = Span { lo: e.span.lo + 1, ..e.span };
                self.whole(&Expr { span, calls: false, kind: ExprKind::Number(-x) });
            }
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                self.operands(condition);
                self.punctuation(Punctuation::Question, Span { lo: condition.span.hi, hi: yes.span.lo });
                self.operands(yes);
                self.punctuation(Punctuation::Colon, Span { lo: yes.span.hi, hi: no.span.lo });
                self.operands(no);
            }
            _ => self.whole(e),
        }
    }
}
