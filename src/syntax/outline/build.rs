//! Builds the outline of a text in one pass over the tokens.

use super::{Declaration, DeclarationKind, Outline, Pair, Token, TokenKind, Use};
use crate::source::{FileId, Sources};
use crate::syntax::tokens::Tokens;
use crate::syntax::word::{Category, entry};
use crate::syntax::{class, tokens_of};
use std::ops::Range;

/// Maximum number of tokens between `deprecated` and the declared name.
const MAX_DEPRECATION: usize = 3;

impl Outline {
    /// Builds the outline of a text from its tokens.
    pub fn new(text: &str, tokens: &Tokens) -> Self {
        let range = |start: u32, end: u32| start as usize..end as usize;
        let classes = tokens.tokens.iter().zip(&tokens.classes);
        // The lexer adds an empty token for each missing `#end`.
        let written = classes.filter(|(token, _)| token.start < token.end);
        let outline = Outline {
            text: text.into(),
            line_starts: memchr::memchr2_iter(b'\n', b'\r', text.as_bytes()).map(|end| end as u32 + 1).collect(),
            base_in_sources: tokens.base_in_sources,
            tokens: written.map(|(token, &class)| outline_token(text, class, range(token.start, token.end))).collect(),
            comments: tokens.comments.iter().map(|&(start, end)| range(start, end)).collect(),
            ..Outline::default()
        };
        let mut builder = Builder { outline, open: vec![], macros: vec![], first_use: 0 };
        for i in 0..builder.outline.tokens.len() {
            builder.visit_token(i);
        }
        builder.leave_unclosed_beyond_depth(0, text.len());
        builder.outline
    }

    /// Builds the outline of a source file.
    pub fn read(sources: &Sources, file: FileId) -> Self {
        let (text, base_in_sources) = (sources.text(file), sources.base(file));
        Self::new(text, &tokens_of(text, base_in_sources).0)
    }
}

fn outline_token(text: &str, class: u8, range: Range<usize>) -> Token {
    use class::*;
    let kind = match class {
        KEYWORD | FUNCTION | DEPRECATED => TokenKind::Word(Category::Keyword),
        BUILTIN => TokenKind::Word(Category::Function),
        // Names include constants; a word before a block is of any category.
        NAME | HEAD => match entry(&text[range.clone()]).map(|word| word.category) {
            None | Some(Category::Contextual) => TokenKind::Name,
            Some(category) => TokenKind::Word(category),
        },
        NUMBER | LITERAL | NUMBERS => TokenKind::Number,
        STRING => TokenKind::String,
        class if is_directive(class) => TokenKind::Directive,
        _ => TokenKind::Sign,
    };
    Token { range, kind, class, pair: None }
}

/// Builder that adds one token after another to an outline.
struct Builder {
    outline: Outline,
    /// Indices of the pairs that are open before the present token.
    open: Vec<usize>,
    /// Indices of the pairs of the macros that are open before the present token.
    macros: Vec<usize>,
    /// Index of the first token that can be a use of a name; the directive before has already read the earlier ones.
    first_use: usize,
}

impl Builder {
    fn visit_token(&mut self, i: usize) {
        self.set_enclosing_pair(i);
        match self.outline.class(i) {
            class::BRACE | class::PAREN | class::BRACKET | class::VECTOR => self.open_bracket(i),
            class::LOOSE if matches!(self.outline.token_text(i), "{" | "(" | "[") => self.open_bracket(i),
            class::BRACE_END => self.close(b'{', i),
            class::PAREN_END => self.close(b'(', i),
            class::BRACKET_END => self.close(b'[', i),
            class::VECTOR_END => self.close(b'<', i),
            class if class::is_directive(class) => self.visit_directive(class, i),
            _ if i >= self.first_use && self.is_name(i) => self.add_use(i, true),
            _ => {}
        }
    }

    /// True if the token of this index is a name.
    fn is_name(&self, i: usize) -> bool {
        self.outline.tokens.get(i).is_some_and(|token| token.kind == TokenKind::Name)
    }

    fn range(&self, i: usize) -> Range<usize> {
        self.outline.tokens[i].range.clone()
    }

    /// Records the innermost open pair as the one that encloses the token of this index; `None` outside of all pairs.
    fn set_enclosing_pair(&mut self, token: usize) {
        self.outline.tokens[token].pair = self.open.last().map(|&pair| pair as u32);
    }

    /// Opens a pair of brackets, whose head is the word before.
    fn open_bracket(&mut self, i: usize) {
        let start = self.range(i).start;
        let before = i.checked_sub(1).map(|before| &self.outline.tokens[before]);
        let head = before.filter(|token| matches!(token.kind, TokenKind::Name | TokenKind::Word(_)));
        self.open(head.map_or(start..start, |token| token.range.clone()), i);
    }

    fn open(&mut self, head: Range<usize>, opener_token: usize) {
        let (range, outer) = (self.range(opener_token), self.open.last().copied());
        let bracket = self.outline.text.as_bytes()[range.start];
        self.open.push(self.outline.pairs.len());
        self.outline.pairs.push(Pair { bracket, head, range, opener: opener_token, closer: None, outer });
    }

    /// Closes the innermost pair with this opening character that has a partner. Pairs inside it remain unclosed.
    fn close(&mut self, bracket: u8, closer_token: usize) {
        let Outline { pairs, tokens, .. } = &self.outline;
        let is_own = |&pair: &usize| pairs[pair].bracket == bracket && tokens[pairs[pair].opener].class != class::LOOSE;
        let Some(depth) = self.open.iter().rposition(is_own) else { return };
        let own = self.open[depth];
        self.leave_unclosed_beyond_depth(depth, self.range(closer_token).end);
        self.outline.pairs[own].closer = Some(closer_token);
        self.outline.tokens[closer_token].pair = Some(own as u32);
    }

    /// Ends all open pairs but the outermost `depth` ones, without a closing token.
    fn leave_unclosed_beyond_depth(&mut self, depth: usize, end_byte: usize) {
        self.open.drain(depth..).for_each(|pair| self.outline.pairs[pair].range.end = end_byte);
    }

    fn visit_directive(&mut self, class: u8, i: usize) {
        if class::class_opens_body(class) {
            let (word, end) = (self.outline.directive_word(&self.outline.tokens[i]), self.range(i).end);
            self.open(end - word.len()..end, i);
        }
        match class {
            class::DECLARE => self.visit_declare_directive(i),
            class::MACRO => self.visit_macro_directive(i),
            class::FOR if self.is_name(i + 2) => self.add_declaration(i + 2, DeclarationKind::Counter, i),
            class::ELSE | class::ELSEIF | class::CASE | class::RANGE => self.begin_next_branch(i),
            class::END => self.visit_end_directive(i),
            class::PLAIN => self.visit_plain_directive(i),
            _ => {}
        }
    }

    /// Reads `#declare A =`, `#local A =` or `#declare A[0] =`, up to the name.
    fn visit_declare_directive(&mut self, i: usize) {
        let mut name = i + 1;
        if self.outline.class(name) == class::DEPRECATED {
            // `#declare deprecated once "message" A =`
            name = (name + 1..=name + 1 + MAX_DEPRECATION).find(|&at| self.is_name(at)).unwrap_or(name);
        }
        let is_local = self.outline.token_text(i).ends_with("local");
        match self.outline.class(name + 1) {
            _ if !self.is_name(name) => {}
            class::EQUAL if is_local => self.add_declaration(name, DeclarationKind::Local, i),
            class::EQUAL => self.add_declaration(name, DeclarationKind::Declare, i),
            _ => self.add_use(name, false),
        }
    }

    /// Reads `#macro A(B, optional C)`, up to the closing parenthesis.
    fn visit_macro_directive(&mut self, i: usize) {
        let is_named = self.is_name(i + 1);
        if is_named {
            self.add_declaration(i + 1, DeclarationKind::Macro, i);
        }
        self.macros.extend(self.open.last());
        if !is_named || self.outline.token_text(i + 2) != "(" {
            return;
        }
        let may_be_between =
            |token: &Token| matches!(token.kind, TokenKind::Name | TokenKind::Sign | TokenKind::Word(_));
        let mut at = i + 3;
        while self.outline.token_text(at) != ")" && self.outline.tokens.get(at).is_some_and(may_be_between) {
            // `optional C`: the second name is the parameter.
            if self.is_name(at) && !self.is_name(at + 1) {
                self.add_declaration(at, DeclarationKind::Parameter, i);
            }
            at += 1;
        }
        self.first_use = at;
    }

    /// Begins the next branch of the innermost directive: brackets of the branch before remain unclosed.
    fn begin_next_branch(&mut self, i: usize) {
        let body = self.open.iter().rposition(|&pair| self.outline.pairs[pair].bracket == b'#');
        self.leave_unclosed_beyond_depth(body.map_or(0, |body| body + 1), self.range(i).end);
        self.set_enclosing_pair(i);
    }

    fn visit_end_directive(&mut self, i: usize) {
        self.close(b'#', i);
        let Outline { pairs, declarations, .. } = &mut self.outline;
        if let Some(own) = self.macros.pop_if(|own| pairs[*own].closer == Some(i)) {
            let range = &pairs[own].range;
            let is_own = |d: &&mut Declaration| d.kind == DeclarationKind::Macro && d.whole.start == range.start;
            declarations.iter_mut().rev().find(is_own).into_iter().for_each(|d| d.whole.end = range.end);
        }
    }

    fn visit_plain_directive(&mut self, i: usize) {
        match self.outline.directive_word(&self.outline.tokens[i]) {
            "undef" if self.is_name(i + 1) => self.add_use(i + 1, false),
            "include" if self.outline.class(i + 1) == class::STRING => {
                let Range { start, end } = self.range(i + 1);
                self.outline.includes.push(start + 1..end - 1);
            }
            _ => {}
        }
    }

    /// Adds the declaration of a name by a directive.
    fn add_declaration(&mut self, name_token: usize, kind: DeclarationKind, directive_token: usize) {
        let (range, scope) = (self.range(name_token), self.macros.last().copied());
        let whole = self.range(directive_token).start..range.end;
        self.outline.declarations.push(Declaration {
            name: self.outline.token_text(name_token).into(),
            range,
            kind,
            scope,
            whole,
        });
        self.first_use = name_token + 1;
    }

    fn add_use(&mut self, name_token: usize, is_read: bool) {
        self.outline.uses.push(Use { range: self.range(name_token), is_read, scope: self.macros.last().copied() });
        self.first_use = name_token + 1;
    }
}
