//! The syntax tree: a sequence of elements with their spans. Nothing is evaluated; tokens and comments are kept beside
//! the tree.

use super::tokens::Tokens;
use super::word::Word;
use crate::source::Span;
use std::sync::Arc;

/// A name that the author chose, or a constant of the language; an index into [`super::Names`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// A parsed file, possibly with faults.
#[derive(Debug, Default)]
pub struct Ast {
    /// Outermost elements.
    pub elements: Vec<Element>,
    /// All tokens and comments of the file: with the blanks between them they are its text.
    pub tokens: Tokens,
    /// Brackets that are not closed in the rest of the file.
    pub unclosed: Vec<Span>,
}

/// An element of a file, block, entry, group, directive's body, or macro's argument list.
#[derive(Clone, Debug)]
pub struct Element {
    /// The element's span.
    pub span: Span,
    /// True if a comma follows.
    pub comma: bool,
    /// The kind of element.
    pub kind: ElementKind,
}

impl Element {
    /// An element without a comma.
    pub fn new(span: Span, kind: ElementKind) -> Self {
        Self { span, comma: false, kind }
    }
}

/// Kinds of elements.
#[derive(Clone, Debug)]
pub enum ElementKind {
    /// A keyword, or the name of a built-in function without arguments.
    Word(&'static Word),
    /// A number, vector, string, name, call or a combination of them.
    Expr(Box<Expr>),
    /// Two or more literal numbers and vectors with commas between them.
    Numbers(Box<NumberList>),
    /// `name { … }`.
    Block(Box<Block>),
    /// `{ … }` without a name.
    Group(Box<Group>),
    /// `[ … ]`.
    Entry(Box<Group>),
    /// `function (…) { … }`.
    Function(Box<Function>),
    /// `#…`
    Directive(Box<Directive>),
    /// `;`
    Semicolon,
    /// A comma that follows no element of its sequence.
    Comma,
    /// Any other token: an operator without its operands, a bracket without its partner.
    Sign(Sign),
}

/// A token that is neither a word nor a literal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// An opening bracket.
    Open(Bracket),
    /// A closing one.
    Close(Bracket),
    /// Between two operands; `<` and `>` may also enclose a vector, `-` and `+` precede an operand.
    Operator(Operator),
    /// `!`
    Not,
    /// `.`
    Dot,
    /// `?`
    Question,
    /// `:`
    Colon,
    /// A character without meaning in the language.
    Other,
}

/// Brackets other than `<` and `>`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bracket {
    /// `{ }`
    Brace,
    /// `( )`
    Paren,
    /// `[ ]`
    Square,
}

impl Bracket {
    /// The opening and the closing bracket.
    pub fn text(self) -> [&'static str; 2] {
        match self {
            Bracket::Brace => ["{", "}"],
            Bracket::Paren => ["(", ")"],
            Bracket::Square => ["[", "]"],
        }
    }
}

/// The contents of brackets without a name.
#[derive(Clone, Debug)]
pub struct Group {
    /// The elements between the brackets.
    pub body: Box<[Element]>,
}

/// A name and its elements.
#[derive(Clone, Debug)]
pub struct Block {
    /// The word before the brace.
    pub name: Name,
    /// The elements between the braces.
    pub body: Box<[Element]>,
}

/// A word before a brace: a keyword, or an unknown word (an error that is reported when the run reaches it).
#[derive(Clone, Copy, Debug)]
pub struct Name {
    /// The keyword; `None` for an unknown word.
    pub word: Option<&'static str>,
    /// The word's span.
    pub span: Span,
}

/// Literal numbers and vectors.
#[derive(Clone, Debug)]
pub struct NumberList {
    /// All numbers of all items.
    pub data: Arc<[f64]>,
    /// Number of components of each item.
    pub widths: Widths,
}

/// Number of components of each item of a list; 1 is a plain number.
#[derive(Clone, Debug)]
pub enum Widths {
    /// Equal for all items.
    Uniform(u16),
    /// A number for each item.
    Mixed(Arc<[u16]>),
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// The expression's span.
    pub span: Span,
    /// True if a name is called somewhere in it. Only the run decides what the name is.
    pub calls: bool,
    /// The kind of expression.
    pub kind: ExprKind,
}

impl Expr {
    /// True if it compares or chooses, outside of its brackets, which has a meaning only in parentheses, conditions and
    /// colours.
    pub fn compares(&self) -> bool {
        match &self.kind {
            ExprKind::Chain(chain) => {
                let op = chain.rest.first().map(|(op, _)| *op);
                op.is_some_and(|op| !op.adds() && !op.multiplies())
            }
            ExprKind::Choice(_) => true,
            _ => false,
        }
    }
}

/// Kinds of expressions. Chains of operators are flat, so that no tree is deeper than the text's brackets.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A literal.
    Number(f64),
    /// A string literal with its escapes resolved.
    Text(Box<str>),
    /// A name or constant.
    Name(Symbol),
    /// `< … >` of literals only.
    Literal(Arc<[f64]>),
    /// `< … >` of expressions.
    Vector(Box<[Element]>),
    /// `( … )`: kept, because `(A)` passes a copy where `A` passes a reference.
    Paren(Box<Expr>),
    /// `a op b op c …` of one precedence, from left to right.
    Chain(Box<Chain>),
    /// `-`, `+`, `!`.
    Prefix(Prefix, Box<Expr>),
    /// `a ? b : c`
    Choice(Box<[Expr; 3]>),
    /// A built-in function.
    Builtin(&'static Word, Box<[Expr]>),
    /// A macro, user function or spline.
    Call(Symbol, Box<[Element]>),
    /// `A[i][j]`
    Index(Box<Expr>, Box<[Expr]>),
    /// `A[i](x)`
    Apply(Box<Expr>, Box<[Element]>),
    /// `A.x`
    Dot(Box<Expr>, Name, Symbol),
    /// A function as an argument.
    Function(Box<Function>),
    /// A block as an argument.
    Block(Box<Block>),
}

/// Operands and the operators between them.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The first operand.
    pub first: Expr,
    /// The others.
    pub rest: Box<[(Operator, Expr)]>,
}

/// Sign or negation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// `-`
    Minus,
    /// `+`
    Plus,
    /// `!`
    Not,
}

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Operator {
    Add,
    Sub,
    Mul,
    Div,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

impl Operator {
    /// Precedence: a higher number binds more tightly. `&` and `|` have one precedence, from left to right: `(1|0&0)`
    /// is 0 (quirk: `logical_precedence`).
    pub fn precedence(self) -> u8 {
        use Operator::*;
        match self {
            Or | And => 1,
            Less | LessEqual | Greater | GreaterEqual | Equal | NotEqual => 3,
            Add | Sub => 4,
            Mul | Div => 5,
        }
    }

    /// Precedence inside `function { … }`, where `&` binds more tightly than `|` (quirk: `logical_precedence`).
    pub fn precedence_in_functions(self) -> u8 {
        if self == Operator::And { 2 } else { self.precedence() }
    }

    /// The operator with this spelling.
    pub fn of(text: &str) -> Option<Self> {
        use Operator::*;
        let all = [Add, Sub, Mul, Div, Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual, And, Or];
        all.into_iter().find(|op| op.text() == text)
    }

    /// True for `*` and `/`.
    pub fn multiplies(self) -> bool {
        matches!(self, Operator::Mul | Operator::Div)
    }

    /// True for `+` and `-`.
    pub fn adds(self) -> bool {
        matches!(self, Operator::Add | Operator::Sub)
    }

    /// True for comparisons.
    pub fn compares(self) -> bool {
        self.precedence() == Operator::Equal.precedence()
    }

    /// Returns the operator as written in a scene, such as `<=`.
    pub fn text(self) -> &'static str {
        use Operator::*;
        match self {
            Add => "+",
            Sub => "-",
            Mul => "*",
            Div => "/",
            Less => "<",
            LessEqual => "<=",
            Greater => ">",
            GreaterEqual => ">=",
            Equal => "=",
            NotEqual => "!=",
            And => "&",
            Or => "|",
        }
    }
}

/// `function { … }`.
#[derive(Clone, Debug)]
pub struct Function {
    /// The names in parentheses; empty means `x, y, z`.
    pub parameters: Box<[Symbol]>,
    /// `function 200, 200 { … }` of a height field.
    pub size: Box<[Expr]>,
    /// Expressions, blocks (`pigment { … }`) and directives.
    pub body: Box<[Element]>,
}

/// A directive.
#[derive(Clone, Debug)]
pub enum Directive {
    /// `#declare`, `#local`; the value is what the following elements evaluate to.
    Declare(Declare),
    /// `#declare` or `#local` with anything but a plain target before the `=`; the flag is `local`.
    DeclarePieces(bool),
    /// `#if`, `#elseif`, `#else`.
    If(Box<[Branch]>),
    /// `#while`.
    While(Head, Box<[Element]>),
    /// `#for`.
    For(For),
    /// `#switch`.
    Switch(Head, Box<[Arm]>),
    /// `#macro`.
    Macro(Macro),
    /// Any other directive, by its word: its arguments are the elements that follow.
    Plain(Symbol),
}

/// The parentheses after a directive's word.
#[derive(Clone, Debug)]
pub enum Head {
    /// One expression.
    Whole(Expr),
    /// Anything else; `None` if there are no parentheses.
    Pieces(Option<Box<[Element]>>),
}

/// `#declare A[i] =`
#[derive(Clone, Debug)]
pub struct Declare {
    /// `#local`.
    pub local: bool,
    /// `deprecated "why"`; the flag is `once`.
    pub deprecated: Option<(bool, Box<str>)>,
    /// The name, its indices and its span.
    pub target: Target,
    /// The other targets of `#declare (A, B) = (1, 2);`
    pub others: Box<[Target]>,
}

/// The target of a `#declare`.
#[derive(Clone, Debug)]
pub struct Target {
    /// The name.
    pub symbol: Symbol,
    /// The name's span, without indices.
    pub span: Span,
    /// A keyword can't be declared: an error when the run reaches it.
    pub keyword: Option<&'static str>,
    /// `[i][j]`
    pub indices: Box<[Expr]>,
}

/// A condition and the elements that run if it holds.
#[derive(Clone, Debug)]
pub struct Branch {
    /// From its directive's word to the next one.
    pub span: Span,
    /// The condition.
    pub condition: Condition,
    /// The elements that run.
    pub body: Box<[Element]>,
}

/// The condition of a branch.
#[derive(Clone, Debug)]
pub enum Condition {
    /// The value is not 0.
    True(Head),
    /// The name is declared.
    Declared(Head),
    /// The name is not declared.
    NotDeclared(Head),
    /// `#else`.
    Always,
}

/// `#for (I, 0, 10, 1)`
#[derive(Clone, Debug)]
pub struct For {
    /// The counter and its range.
    pub head: ForHead,
    /// The body.
    pub body: Box<[Element]>,
}

/// The parentheses of a `#for`.
#[derive(Clone, Debug)]
pub enum ForHead {
    /// The counter; first value, last value, and an optional step.
    Whole(Symbol, Box<[Expr]>),
    /// Anything else; `None` if there are no parentheses.
    Pieces(Option<Box<[Element]>>),
}

/// One arm of a `#switch`.
#[derive(Clone, Debug)]
pub struct Arm {
    /// From its directive's word to the next one.
    pub span: Span,
    /// The condition.
    pub when: When,
    /// The elements that run; without `#break` the next arm follows.
    pub body: Box<[Element]>,
}

/// The condition of an arm.
#[derive(Clone, Debug)]
pub enum When {
    /// `#case`.
    Case(Head),
    /// `#range`, with both ends.
    Range(Option<Box<[Element]>>),
    /// `#else`.
    Otherwise,
}

/// `#macro Name(A, B)`
#[derive(Clone, Debug)]
pub struct Macro {
    /// Its name.
    pub name: Symbol,
    /// The name's span.
    pub span: Span,
    /// Span of a faulty part of its head: an error when the run reaches it.
    pub fault: Option<Span>,
    /// Names of its parameters; the flag is `optional`.
    pub parameters: Box<[(Symbol, bool)]>,
    /// The elements that a call runs.
    pub body: Box<[Element]>,
}
