//! Splits expressions into lists of elements, where a macro or text after the expression may change the precedence.

use crate::source::Span;
use crate::syntax::Names;
use crate::syntax::ast::*;
use crate::syntax::word;

/// Returns the parts of an expression, one level down: operators and operands, or brackets and their contents.
pub fn split_one_level(e: &Expr, names: &Names) -> Vec<Element> {
    let mut out = Pieces(vec![]);
    match &e.kind {
        ExprKind::Paren(inner) => out.push_bracketed(Bracket::Paren, e.span, |out| out.push_whole(inner)),
        ExprKind::Vector(parts) => {
            out.push_punctuation(Punctuation::Operator(Operator::Less), Span { hi: e.span.lo + 1, ..e.span });
            out.0.extend(parts.iter().cloned());
            out.push_punctuation(Punctuation::Operator(Operator::Greater), Span { lo: e.span.hi - 1, ..e.span });
        }
        ExprKind::Literal(data) => {
            out.push_punctuation(Punctuation::Operator(Operator::Less), Span { hi: e.span.lo + 1, ..e.span });
            for x in data.iter() {
                out.push_whole(&Expr { span: e.span, calls: false, kind: ExprKind::Number(*x) });
                out.mark_comma_after_last();
            }
            out.push_punctuation(Punctuation::Operator(Operator::Greater), Span { lo: e.span.hi - 1, ..e.span });
        }
        ExprKind::Builtin(name, arguments) => {
            let span = Span { hi: e.span.lo + name.name.len() as u32, ..e.span };
            out.0.push(Element::new(span, ElementKind::Word(name)));
            let brackets = Span { lo: span.hi, ..e.span };
            out.push_bracketed(Bracket::Paren, brackets, |out| {
                for argument in arguments {
                    out.push_whole(argument);
                    out.mark_comma_after_last();
                }
                out.unmark_comma_after_last();
            });
        }
        ExprKind::Call(symbol, arguments) => {
            let span = Span { hi: e.span.lo + names.text(*symbol).len() as u32, ..e.span };
            out.push_whole(&Expr { span, calls: false, kind: ExprKind::Name(*symbol) });
            out.push_arguments(arguments, Span { lo: span.hi, ..e.span });
        }
        ExprKind::Index(base, indices) => {
            out.push_whole(base);
            for index in indices {
                let span = Span { lo: index.span.lo.saturating_sub(1), hi: index.span.hi + 1 };
                out.push_bracketed(Bracket::Square, span, |out| out.push_whole(index));
            }
        }
        ExprKind::Apply(base, arguments) => {
            out.push_whole(base);
            out.push_arguments(arguments, Span { lo: base.span.hi, ..e.span });
        }
        ExprKind::Dot(base, name, symbol) => {
            out.push_whole(base);
            out.push_punctuation(Punctuation::Dot, Span { lo: base.span.hi, hi: name.span.lo });
            let keyword = name.word.and_then(word::entry).filter(|w| w.category != word::Category::Constant);
            match keyword {
                Some(word) => out.0.push(Element::new(name.span, ElementKind::Word(word))),
                None => out.push_whole(&Expr { span: name.span, calls: false, kind: ExprKind::Name(*symbol) }),
            }
        }
        _ => out.push_operands(e),
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
    fn push_whole(&mut self, e: &Expr) {
        let kind = match &e.kind {
            ExprKind::Block(block) => ElementKind::Block(block.clone()),
            ExprKind::Function(function) => ElementKind::Function(function.clone()),
            _ => ElementKind::Expr(Box::new(e.clone())),
        };
        self.0.push(Element::new(e.span, kind));
    }

    fn push_punctuation(&mut self, mark: Punctuation, span: Span) {
        self.0.push(Element::new(span, ElementKind::Punctuation(mark)));
    }

    fn mark_comma_after_last(&mut self) {
        self.0.last_mut().into_iter().for_each(|last| last.comma = true);
    }

    fn unmark_comma_after_last(&mut self) {
        self.0.last_mut().into_iter().for_each(|last| last.comma = false);
    }

    fn push_bracketed(&mut self, bracket: Bracket, span: Span, fill: impl FnOnce(&mut Self)) {
        self.push_punctuation(Punctuation::Open(bracket), Span { hi: span.lo + 1, ..span });
        fill(self);
        self.push_punctuation(Punctuation::Close(bracket), Span { lo: span.hi.saturating_sub(1), ..span });
    }

    fn push_arguments(&mut self, arguments: &[Element], span: Span) {
        self.push_bracketed(Bracket::Paren, span, |out| out.0.extend(arguments.iter().cloned()));
    }

    /// Appends the operands and operators of a chain, in the order of the text.
    fn push_operands(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::Chain(chain) => {
                self.push_operands(&chain.first);
                let mut end = chain.first.span.hi;
                for (op, operand) in &chain.rest {
                    self.push_punctuation(Punctuation::Operator(*op), Span { lo: end, hi: operand.span.lo });
                    self.push_operands(operand);
                    end = operand.span.hi;
                }
            }
            ExprKind::Prefix(prefix, inner) => {
                let mark = match prefix {
                    Prefix::Minus => Punctuation::Operator(Operator::Sub),
                    Prefix::Plus => Punctuation::Operator(Operator::Add),
                    Prefix::Not => Punctuation::Not,
                };
                self.push_punctuation(mark, Span { hi: e.span.lo + 1, ..e.span });
                self.push_operands(inner);
            }
            ExprKind::Number(x) if x.is_sign_negative() => {
                self.push_punctuation(Punctuation::Operator(Operator::Sub), Span { hi: e.span.lo + 1, ..e.span });
                let span = Span { lo: e.span.lo + 1, ..e.span };
                self.push_whole(&Expr { span, calls: false, kind: ExprKind::Number(-x) });
            }
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                self.push_operands(condition);
                self.push_punctuation(Punctuation::Question, Span { lo: condition.span.hi, hi: yes.span.lo });
                self.push_operands(yes);
                self.push_punctuation(Punctuation::Colon, Span { lo: yes.span.hi, hi: no.span.lo });
                self.push_operands(no);
            }
            _ => self.push_whole(e),
        }
    }
}
