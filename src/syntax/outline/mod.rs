//! Outline of a scene's text: tokens, comments, brackets, and declarations and uses of names. Lints, the search for
//! unclosed brackets and the language server are walkers of an outline, and consist of their own rules only.
//!
//! Every text has an outline, since the lexer accepts every text. Where brackets are broken, the lexer decides which of
//! them belong together: the partner of a bracket is in the same branch of the same directive.

mod build;

use super::class;
use super::word::Category;
use crate::source::Span;
use std::ops::Range;

/// Kind of a token in a scene's text, for editors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// Token that is a reserved word of the scene language.
    Word(Category),
    /// Token that is a name chosen by the scene's author.
    Name,
    /// Token that is a directive, `#…`.
    Directive,
    /// Token that is a string, `"…"`.
    String,
    /// Token that is a number, or a list of numbers.
    Number,
    /// Token that is a bracket, an operator, a comma or a character without meaning.
    Sign,
}

/// Token of a scene's text. Comments are not tokens.
#[derive(Clone, Debug)]
pub struct Token {
    /// Byte range of the token in the text.
    pub range: Range<usize>,
    /// Kind of the token, for editors.
    pub kind: TokenKind,
    /// Lexical class of the token, for lints.
    class: u8,
    /// Index of the innermost pair that encloses the token; a closing token belongs to its own pair.
    pair: Option<u32>,
}

/// A pair of brackets, or a directive with a body and its `#end`.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Character that opens the pair: `{`, `(`, `[`, `<` of a vector, or `#`. Vectors of plain numbers are no pairs.
    pub bracket: u8,
    /// Byte range of the word directly before the bracket, or of the directive's word; empty without such a word.
    pub head: Range<usize>,
    /// Byte range from the opening token to the end of the closing one. An unclosed pair extends to the end of the
    /// token that closes an enclosing pair, or of the text.
    pub range: Range<usize>,
    /// Index of the pair's opening token in the outline's tokens.
    pub opener: usize,
    /// Index of the pair's closing token in the outline's tokens; `None` for an unclosed pair.
    pub closer: Option<usize>,
    /// Index of the innermost pair that encloses this pair.
    pub outer: Option<usize>,
}

/// Directive or construct that declares a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeclarationKind {
    /// Declared by `#declare`.
    Declare,
    /// Declared by `#local`.
    Local,
    /// Declared by `#macro`.
    Macro,
    /// Declaration of a macro's parameter.
    Parameter,
    /// Declaration of a `#for` loop's counter.
    Counter,
}

/// Declaration of a name in a scene's text.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Name that the declaration introduces.
    pub name: String,
    /// Byte range of the declared name.
    pub range: Range<usize>,
    /// Kind of the declaration.
    pub kind: DeclarationKind,
    /// Index of the pair of the innermost macro that encloses the declaration; for a parameter, its own macro.
    pub scope: Option<usize>,
    /// Byte range from the directive to the name, or to the `#end` of a macro.
    pub whole: Range<usize>,
}

/// Use of a name in a scene's text. The text alone does not show whether the name is declared.
#[derive(Clone, Debug)]
pub struct Use {
    /// Byte range of the used name.
    pub range: Range<usize>,
    /// False if the name is only removed by `#undef`, or if `#declare` assigns to an element of it.
    pub is_read: bool,
    /// Index of the pair of the innermost macro that encloses the use.
    pub scope: Option<usize>,
}

/// Line that contains a byte offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// Byte offset of the line's first character.
    pub start: usize,
    /// Width of the blanks at the line's start, in columns; a tab has eight.
    pub indent: usize,
    /// True if only blanks precede the offset in its line.
    pub is_first: bool,
}

/// Outline of a scene's text. All lists are in the order of the text.
#[derive(Debug, Default)]
pub struct Outline {
    text: Box<str>,
    /// Byte offsets of the lines after the first, ascending.
    line_starts: Vec<u32>,
    /// Global offset of the text's first byte.
    base_in_sources: usize,
    /// Tokens of the text.
    pub tokens: Vec<Token>,
    /// Byte ranges of the comments, with their delimiters.
    pub comments: Vec<Range<usize>>,
    /// Pairs in the order of their opening tokens.
    pub pairs: Vec<Pair>,
    /// Declarations of names.
    pub declarations: Vec<Declaration>,
    /// Uses of names.
    pub uses: Vec<Use>,
    /// Byte ranges of the names of included files, without quotes.
    pub includes: Vec<Range<usize>>,
}

impl Outline {
    /// Returns the text of a byte range, which is one of the outline's own.
    pub fn slice(&self, range: &Range<usize>) -> &str {
        self.text.get(range.clone()).unwrap_or_default()
    }

    /// Returns the word of a directive's token, without `#`; empty for another token.
    pub fn directive_word(&self, token: &Token) -> &str {
        let is_blank = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
        self.slice(&token.range).strip_prefix('#').map_or("", |word| word.trim_start_matches(is_blank))
    }

    /// Returns the word before a pair's bracket, or the word of a directive's pair.
    pub fn head(&self, pair: &Pair) -> &str {
        self.slice(&pair.head)
    }

    /// Returns the index of the first token that starts at a byte offset or after it.
    pub fn first_token_from(&self, offset: usize) -> usize {
        self.tokens.partition_point(|token| token.range.start < offset)
    }

    /// Returns the token that contains a byte offset or touches it. Of two tokens, a word is preferred to a sign.
    pub fn token_at(&self, offset: usize) -> Option<&Token> {
        let i = self.tokens.partition_point(|token| token.range.end < offset);
        let touches = |i: usize| self.tokens.get(i).filter(|token| token.range.start <= offset);
        let first = touches(i)?;
        Some(touches(i + 1).filter(|_| first.kind == TokenKind::Sign).unwrap_or(first))
    }

    /// Returns the comment that contains a byte offset or touches it.
    pub fn comment_at(&self, offset: usize) -> Option<&Range<usize>> {
        let i = self.comments.partition_point(|comment| comment.end < offset);
        self.comments.get(i).filter(|comment| comment.start <= offset)
    }

    /// Returns the innermost pair around a byte offset for which `holds` is true. An unclosed pair contains the rest of
    /// the text.
    pub fn pair_at(&self, offset: usize, holds: impl Fn(&Pair) -> bool) -> Option<&Pair> {
        let inside = |pair: &&Pair| pair.range.start < offset && (offset < pair.range.end || pair.closer.is_none());
        self.pairs.iter().rev().filter(inside).find(|pair| holds(pair))
    }

    /// Returns the index of the pair of the innermost macro around a byte offset.
    pub fn macro_pair_at(&self, offset: usize) -> Option<usize> {
        let last = self.pairs.partition_point(|pair| pair.range.start < offset).checked_sub(1);
        let mut around = self.pair_and_enclosing_pairs(last).filter(|&pair| offset < self.pairs[pair].range.end);
        around.find(|&pair| self.is_macro(&self.pairs[pair]))
    }

    /// Returns the index of the pair of the innermost macro, from the macro `scope` outwards, that declares a name as a
    /// local, parameter or loop counter; `None` for a global name.
    pub fn declaring_macro_pair(&self, name: &str, scope: Option<usize>) -> Option<usize> {
        use DeclarationKind::{Counter, Local, Parameter};
        let owns = |pair: &usize| {
            let mut own = self.declarations.iter().filter(|d| d.scope == Some(*pair) && d.name == name);
            own.any(|d| matches!(d.kind, Local | Parameter | Counter))
        };
        self.pair_and_enclosing_pairs(scope).filter(|&pair| self.is_macro(&self.pairs[pair])).find(owns)
    }

    /// Returns the names of the parameters of a macro. `definition` is the declaration of the macro's name.
    pub fn parameters(&self, definition: &Declaration) -> impl Iterator<Item = &str> {
        let first = self.declarations.partition_point(|d| d.range.start <= definition.range.start);
        let start = definition.whole.start;
        self.declarations[first..].iter().take_while(move |d| d.whole.start == start).map(|d| d.name.as_str())
    }

    /// Returns the line that contains a byte offset.
    pub fn line_at(&self, offset: usize) -> Line {
        let after = self.line_starts.partition_point(|&start| start as usize <= offset);
        let start = after.checked_sub(1).map_or(0, |line| self.line_starts[line] as usize);
        let blanks = self.text[start..].bytes().take_while(|b| matches!(b, b' ' | b'\t'));
        let add = |(count, width), b| (count + 1, width + if b == b'\t' { 8 } else { 1 });
        let (count, indent) = blanks.fold((0, 0), add);
        Line { start, indent, is_first: start + count >= offset }
    }

    /// True if the pair is a macro's definition.
    pub fn is_macro(&self, pair: &Pair) -> bool {
        self.class(pair.opener) == class::MACRO
    }

    /// Returns the indices of a pair and of all pairs around it, the innermost first.
    fn pair_and_enclosing_pairs(&self, pair: Option<usize>) -> impl Iterator<Item = usize> {
        std::iter::successors(pair, |&inner| self.pairs[inner].outer)
    }
}

/// Access by the indices of tokens, for rules that look at neighbours. An index after the last token is allowed.
impl Outline {
    /// Returns the lexical class of a token; 0 after the last one.
    pub(super) fn class(&self, token: usize) -> u8 {
        self.tokens.get(token).map_or(0, |token| token.class)
    }

    /// Returns the lexical class of the token before `token`; 0 before the first one.
    pub(super) fn class_before(&self, token: usize) -> u8 {
        token.checked_sub(1).map_or(0, |before| self.class(before))
    }

    /// Returns the text of a token; empty after the last one.
    pub(super) fn token_text(&self, token: usize) -> &str {
        self.tokens.get(token).map_or("", |token| self.slice(&token.range))
    }

    /// Returns the global span of a token; [`Span::NONE`] after the last one.
    pub(super) fn token_span(&self, token: usize) -> Span {
        self.tokens.get(token).map_or(Span::NONE, |token| self.span(&token.range))
    }

    /// Returns the global span of a byte range of the text.
    pub(super) fn span(&self, range: &Range<usize>) -> Span {
        Span::new(self.base_in_sources + range.start, self.base_in_sources + range.end)
    }

    /// Returns the pairs around a token, the innermost first. A closing token belongs to its own pair, an opening one
    /// does not.
    pub(super) fn pairs_around(&self, token: usize) -> impl Iterator<Item = &Pair> {
        let innermost = self.tokens.get(token).and_then(|token| token.pair);
        self.pair_and_enclosing_pairs(innermost.map(|pair| pair as usize)).map(|pair| &self.pairs[pair])
    }

    /// Returns the pair that a token opens.
    pub(super) fn opened_by(&self, token: usize) -> Option<&Pair> {
        self.pairs.binary_search_by_key(&token, |pair| pair.opener).ok().map(|index| &self.pairs[index])
    }

    /// Returns the pair that a token closes.
    pub(super) fn closed_by(&self, token: usize) -> Option<&Pair> {
        self.pairs_around(token).next().filter(|pair| pair.closer == Some(token))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::tokens_of;

    fn outline(text: &str) -> Outline {
        Outline::new(text, &tokens_of(text, 1).0)
    }

    /// The number of a pair, or `-`.
    fn number(pair: Option<usize>) -> String {
        pair.map_or("-".into(), |pair| pair.to_string())
    }

    /// The pairs of a text: head, enclosing pair, and the text up to the closing token, or `unclosed`.
    fn pairs(text: &str) -> Vec<String> {
        let outline = outline(text);
        let row = |pair: &Pair| {
            let whole = pair.closer.map_or("unclosed", |_| outline.slice(&pair.range));
            format!("{} {}: {whole}", outline.head(pair), number(pair.outer))
        };
        outline.pairs.iter().map(row).collect()
    }

    /// The declarations of a text: kind, enclosing macro, whole text, and parameters.
    fn declarations(text: &str) -> Vec<String> {
        let outline = outline(text);
        let row = |d: &Declaration| {
            assert_eq!(d.name, outline.slice(&d.range));
            let is_macro = d.kind == DeclarationKind::Macro;
            let parameters = if is_macro { outline.parameters(d).collect() } else { vec![] }.join("+");
            format!("{:?} {}: {} {parameters}", d.kind, number(d.scope), outline.slice(&d.whole))
        };
        outline.declarations.iter().map(row).collect()
    }

    /// The uses of names in a text, with their enclosing macros; names that are not read in brackets.
    fn uses(text: &str) -> Vec<String> {
        let outline = outline(text);
        let name = |one: &Use| outline.slice(&one.range).to_string();
        let row = |one: &Use| if one.is_read { name(one) } else { format!("({})", name(one)) } + &number(one.scope);
        outline.uses.iter().map(row).collect()
    }

    #[test]
    fn tokens_have_kinds_for_editors() {
        use TokenKind::*;
        let outline = outline("#local sin x eye Eye object { \"s\" 1.5 <1, 2> /* c */ ~");
        let kinds: Vec<_> = outline.tokens.iter().map(|token| token.kind).collect();
        let words = [Category::Function, Category::Constant].map(Word);
        let rest = [Name, Name, Word(Category::Keyword), Sign, String, Number, Number, Sign];
        assert_eq!(kinds, [&[Directive], &words[..], &rest].concat());
        assert_eq!(outline.comments.iter().map(|one| outline.slice(one)).collect::<Vec<_>>(), ["/* c */"]);
    }

    #[test]
    fn pairs_are_nested() {
        let text = "#if (A) union { sphere { <x, 1> B[0] } }\n# end";
        let union = ["union 0: { sphere { <x, 1> B[0] } }", "sphere 2: { <x, 1> B[0] }", " 3: <x, 1>", "B 3: [0]"];
        assert_eq!(pairs(text)[0], format!("if -: {text}"));
        assert_eq!(pairs(text)[1], " 0: (A)");
        assert_eq!(pairs(text)[2..], union);
    }

    #[test]
    fn pairs_of_broken_texts() {
        let text = "a { ( b[1) } c { [";
        assert_eq!(pairs(text), ["a -: { ( b[1) }", " 0: ( b[1)", "b 1: unclosed", "c -: unclosed", " 3: unclosed"]);
        assert_eq!(outline(text).pairs.iter().map(|pair| pair.range.end).collect::<Vec<_>>(), [12, 10, 10, 18, 18]);
        // Brackets match within one branch of one directive.
        assert_eq!(pairs("#if (1) a { #else } b { } #end")[2..], ["a 0: unclosed", "b 0: { }"]);
        assert_eq!(pairs("#macro M() a { #end b { }")[2..], ["a 0: unclosed", "b -: { }"]);
        assert_eq!(
            pairs("#while (1) #end } #if (0) #for (1) #end")[2..],
            ["if -: unclosed", " 2: (0)", "for 2: #for (1) #end", " 4: (1)"]
        );
    }

    #[test]
    fn macros_have_parameters() {
        let text = "#macro A(B, optional C) #macro D() B #end #local E = C; #end D";
        let declared = declarations(text);
        assert_eq!(declared[0], format!("Macro -: {} B+C", &text[..text.len() - 2]));
        assert_eq!(declared[1..3], ["Parameter 0: #macro A(B ", "Parameter 0: #macro A(B, optional C "]);
        assert_eq!(declared[3..], ["Macro 0: #macro D() B #end ", "Local 0: #local E "]);
        assert_eq!(uses(text), ["B2", "C0", "D-"]);
        let outline = outline(text);
        assert_eq!(
            ["A", "B", "E", "D"].map(|name| outline.declaring_macro_pair(name, Some(2))),
            [None, Some(0), Some(0), None]
        );
        assert_eq!([0, 37, 45, 61].map(|offset| outline.macro_pair_at(offset)), [None, Some(2), Some(0), None]);
        // An unclosed list of parameters ends before the next directive.
        let broken = "#macro A(B #local C = B;";
        assert_eq!(declarations(broken), ["Macro -: #macro A B", "Parameter 0: #macro A(B ", "Local 0: #local C "]);
    }

    #[test]
    fn assignments_declare_names() {
        let text = "#declare A = B; # local C = 1; #declare D[I] = 1; #declare x = 2; #undef E";
        assert_eq!(declarations(text), ["Declare -: #declare A ", "Local -: # local C "]);
        assert_eq!(uses(text), ["B-", "(D)-", "I-", "(E)-"]);
        let deprecated = "#declare deprecated once \"message\" A = B; #local deprecated C = 1;";
        let whole = ["#declare deprecated once \"message\" A", "#local deprecated C"];
        assert_eq!(declarations(deprecated), [format!("Declare -: {} ", whole[0]), format!("Local -: {} ", whole[1])]);
        assert_eq!(uses(deprecated), ["B-"]);
    }

    #[test]
    fn loops_declare_counters() {
        let text = "#for (I, A, 3) I #end #for (1, 2) J #end";
        assert_eq!(declarations(text), ["Counter -: #for (I "]);
        assert_eq!(uses(text), ["A-", "I-", "J-"]);
    }

    #[test]
    fn files_are_included() {
        let outline = outline("#include \"a.inc\" #include A #debug \"b.inc\"");
        assert_eq!(outline.includes.iter().map(|name| outline.slice(name)).collect::<Vec<_>>(), ["a.inc"]);
    }

    #[test]
    fn offsets_have_tokens_pairs_and_lines() {
        let all = outline("a {A }/*c*/ 12\r\n \tb { 3");
        let token = |offset: usize| all.token_at(offset).map_or("", |token| all.slice(&token.range));
        assert_eq!([0, 2, 3, 4, 6, 8, 13, 14].map(token), ["a", "{", "A", "A", "}", "", "12", "12"]);
        assert_eq!([5, 6, 11, 12].map(|at| all.comment_at(at).cloned()), [None, Some(6..11), Some(6..11), None]);
        assert_eq!([0, 1, 2, 99].map(|offset| all.first_token_from(offset)), [0, 1, 1, 8]);
        // An unclosed brace contains the rest of the text.
        let block = |offset: usize| all.pair_at(offset, |pair| pair.bracket == b'{').map(|pair| all.head(pair));
        assert_eq!([2, 3, 6, 23].map(block), [None, Some("a"), None, Some("b")]);
        assert_eq!(all.line_at(18), Line { start: 16, indent: 9, is_first: true });
        assert_eq!(all.line_at(20), Line { start: 16, indent: 9, is_first: false });
    }

    #[test]
    fn tokens_have_neighbours_and_pairs() {
        // A closing token belongs to its own pair, also after an unclosed bracket.
        assert_eq!(outline("a { ( }").closed_by(3).map(|pair| pair.opener), Some(1));
        // The tokens: `#if ( 1 ) a { b } #end`.
        let outline = outline("#if (1) a { b } #end");
        let around = |token: usize| outline.pairs_around(token).map(|pair| outline.head(pair)).collect::<Vec<_>>();
        assert_eq!([around(0), around(5), around(7), around(8)], [vec![], vec!["if"], vec!["a", "if"], vec!["if"]]);
        assert_eq!([5, 7].map(|token| outline.opened_by(token).map(|pair| pair.closer)), [Some(Some(7)), None]);
        assert_eq!([5, 7].map(|token| outline.closed_by(token).map(|pair| pair.opener)), [None, Some(5)]);
        assert_eq!([outline.class(9), outline.class_before(0), outline.class_before(9)], [0, 0, class::END]);
        assert_eq!([outline.token_span(8), outline.token_span(9)], [Span::new(17, 21), Span::NONE]);
    }
}
