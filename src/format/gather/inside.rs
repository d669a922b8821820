//! Gathers the atoms of directives and expressions.

use super::Gatherer;
use crate::format::atoms::flag::*;
use crate::format::atoms::{Arm, Atom, ItemKind};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::word;

impl Gatherer<'_> {
    pub(super) fn gather_directive(&mut self, directive: &Directive, span: Span) -> ItemKind {
        match directive {
            Directive::Declare(declare) => {
                self.gather_target(&declare.target);
                declare.others.iter().for_each(|target| self.gather_target(target));
                return ItemKind::Declare;
            }
            Directive::DeclarePieces(_) | Directive::Plain(_) => return ItemKind::Plain,
            _ => {}
        }
        let start = self.len();
        let mut arms = vec![];
        match directive {
            Directive::If(branches) => {
                for branch in branches {
                    let head = match &branch.condition {
                        Condition::True(head) | Condition::Declared(head) | Condition::NotDeclared(head) => Some(head),
                        Condition::Always => None,
                    };
                    self.gather_arm(&mut arms, branch.span, head, &branch.body, false);
                }
            }
            Directive::While(head, body) => self.gather_arm(&mut arms, span, Some(head), body, false),
            Directive::For(one) => {
                self.gather_for_head(&one.head);
                self.gather_rest_of_arm(&mut arms, start, &one.body, span, false);
            }
            Directive::Switch(head, all) => {
                let first = all.first().map_or(span.end(), |arm| arm.span);
                self.gather_arm(&mut arms, Span { hi: first.lo, ..span }, Some(head), &[], false);
                for one in all {
                    let head = if let When::Case(head) = &one.when { Some(head) } else { None };
                    self.gather_arm(&mut arms, one.span, head, &one.body, true);
                }
            }
            Directive::Macro(one) => {
                self.gather_through(one.span);
                self.pending |= NO_BLANK_BEFORE;
                self.gather_rest_of_arm(&mut arms, start, &one.body, span, false);
            }
            Directive::Declare(_) | Directive::DeclarePieces(_) | Directive::Plain(_) => {}
        }
        self.finish_arms(start, arms, span);
        ItemKind::Bodies
    }

    /// Adds the rest of a directive with bodies, except its last token, and links its first atom `start` to its arms; the
    /// closing `#end` is in no arm.
    fn finish_arms(&mut self, start: usize, mut arms: Vec<Arm>, span: Span) {
        // Everything before it is in the last arm.
        while let Some(piece) = self.pieces.next
            && piece.span().hi < span.hi
        {
            self.pieces.advance();
            self.add_piece(piece);
        }
        let end = self.len() as u32;
        let heads: Vec<_> = arms.iter().skip(1).map(|arm| arm.head).chain([end]).collect();
        arms.iter_mut().zip(heads).for_each(|(arm, end)| arm.end = end);
        self.out.row[start].link = self.out.arms.len() as u32;
        self.out.arms.push(arms);
    }

    fn gather_target(&mut self, target: &Target) {
        self.gather_through(target.span);
        self.gather_indices(&target.indices);
    }

    fn gather_arm(
        &mut self,
        arms: &mut Vec<Arm>,
        span: Span,
        head: Option<&Head>,
        body: &[Element],
        is_switch_arm: bool,
    ) {
        self.gather_before(span);
        let start = self.len();
        self.gather_token();
        match head {
            Some(Head::Whole(e)) => self.gather_expr(e),
            Some(Head::Pieces(Some(elements))) => self.gather_arguments(elements),
            _ => {}
        }
        self.gather_rest_of_arm(arms, start, body, span, is_switch_arm);
    }

    fn gather_for_head(&mut self, head: &ForHead) {
        self.gather_token();
        match head {
            ForHead::Whole(_, parts) => parts.iter().for_each(|e| self.gather_expr(e)),
            ForHead::Pieces(Some(elements)) => self.gather_arguments(elements),
            ForHead::Pieces(None) => {}
        }
    }

    /// Adds the atoms of the rest of a directive's parentheses, and of its body, and appends the arm to `arms`. `start` is the
    /// first atom of the arm.
    fn gather_rest_of_arm(
        &mut self,
        arms: &mut Vec<Arm>,
        start: usize,
        body: &[Element],
        span: Span,
        is_switch_arm: bool,
    ) {
        let first = body.first().map_or(self.local_offset(span.hi), |e| self.local_offset(e.span.lo));
        let text = self.text;
        let depth = |row: &[Atom]| {
            let sign = |a: &Atom| match &text[a.lo as usize..a.hi as usize] {
                "(" => 1,
                ")" => -1,
                _ => 0,
            };
            row[start.min(row.len())..].iter().map(sign).sum::<i32>()
        };
        let mut open = depth(&self.out.row);
        let headless = self.out.row.get(start).is_some_and(|a| {
            let head = &text[..a.hi as usize];
            head.ends_with("else") || head.ends_with("default")
        });
        if open == 0 && !headless && self.len() - start < 3 && self.peek_token_text() == Some("(") {
            self.gather_token();
            open = 1;
        }
        while open > 0
            && let Some(piece) = self.pieces.next
            && self.local_offset(piece.span().lo) < first
        {
            open += match self.peek_token_text() {
                Some("(") => 1,
                Some(")") => -1,
                _ => 0,
            };
            self.pieces.advance();
            self.add_piece(piece);
        }
        self.pending = 0;
        let (head, at) = (start as u32, self.len() as u32);
        self.gather_body(body);
        arms.push(Arm { head, body: at, end: at, is_switch_arm });
    }

    // ------------------------------------------------------------ expressions

    /// Gathers arguments, which are elements but not items of a body.
    fn gather_arguments(&mut self, elements: &[Element]) {
        for e in elements {
            self.gather_before(e.span);
            match &e.kind {
                ElementKind::Expr(expr) => self.gather_expr(expr),
                ElementKind::Block(block) => self.gather_arguments(&block.body),
                ElementKind::Group(group) | ElementKind::Entry(group) => self.gather_arguments(&group.body),
                ElementKind::Function(function) => self.gather_arguments(&function.body),
                _ => {}
            }
            self.gather_through(e.span);
        }
    }

    fn gather_indices(&mut self, indices: &[Expr]) {
        for index in indices {
            self.pending |= NO_BLANK_BEFORE;
            self.gather_expr(index);
            self.gather_through(index.span);
            self.gather_token();
        }
        self.pending = 0;
    }

    fn gather_operand(&mut self, e: &Expr) {
        self.gather_expr(e);
        self.gather_through(e.span);
        self.pending |= OPERATOR;
    }

    fn gather_vector(&mut self, span: Span, parts: &[Element]) {
        self.pending |= OPEN;
        self.gather_token();
        self.gather_arguments(parts);
        self.gather_up_to(self.local_offset(span.hi).saturating_sub(1));
        self.pending = CLOSE;
    }

    pub(super) fn gather_expr(&mut self, e: &Expr) {
        self.gather_before(e.span);
        if self.text[self.local_offset(e.span.lo)..].starts_with(['-', '+', '!']) {
            self.pending |= NO_BLANK_AFTER;
        }
        match &e.kind {
            ExprKind::Vector(parts) => self.gather_vector(e.span, parts),
            // A vector of numbers with a comment between them.
            ExprKind::Literal(_) if self.peek_token_text() == Some("<") => self.gather_vector(e.span, &[]),
            ExprKind::Call(_, parts) => {
                self.gather_token();
                self.pending |= NO_BLANK_BEFORE;
                self.gather_arguments(parts);
            }
            ExprKind::Builtin(_, parts) => {
                self.gather_token();
                self.pending |= NO_BLANK_BEFORE;
                parts.iter().for_each(|e| self.gather_expr(e));
            }
            ExprKind::Paren(inner) | ExprKind::Prefix(_, inner) => self.gather_expr(inner),
            ExprKind::Chain(chain) => {
                self.gather_operand(&chain.first);
                if word::durer_words_of_block(self.block).contains(&self.text_of(chain.first.span)) {
                    // A word and its value: `point -y`.
                    self.pending = NO_BLANK_AFTER;
                }
                chain.rest.iter().for_each(|(_, e)| self.gather_operand(e));
            }
            ExprKind::Choice(parts) => parts.iter().for_each(|e| self.gather_operand(e)),
            ExprKind::Index(base, indices) => {
                self.gather_expr(base);
                self.gather_through(base.span);
                self.gather_indices(indices);
            }
            ExprKind::Apply(base, arguments) => {
                self.gather_expr(base);
                self.gather_through(base.span);
                self.pending |= NO_BLANK_BEFORE;
                self.gather_arguments(arguments);
            }
            ExprKind::Dot(base, ..) => self.gather_expr(base),
            ExprKind::Function(function) => self.gather_arguments(&function.body),
            ExprKind::Block(block) => self.gather_arguments(&block.body),
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Literal(_) => {}
        }
        self.gather_through(e.span);
        self.pending = 0;
    }
}
