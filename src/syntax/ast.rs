//! What is written: a sequence of elements, each with its place. Nothing is evaluated; tokens and comments are kept
//! beside the tree.

use super::tokens::Tokens;
use super::word::Word;
use crate::source::Span;
use std::sync::Arc;

/// A name that the author gave, or a constant of the language; an index into [`super::Names`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// A parsed file, or what could be made of one with faults.
#[derive(Debug, Default)]
pub struct Ast {
    /// Outermost elements.
    pub elements: Vec<Element>,
    /// Every token and comment of the file: with the blanks between them they are its text.
    pub tokens: Tokens,
    /// Brackets that nothing in the rest of the file closes.
    pub unclosed: Vec<Span>,
}

/// Something in a file, block, entry, group, directive's body, or macro's argument list.
#[derive(Clone, Debug)]
pub struct Element {
    /// All of it.
    pub span: Span,
    /// Does a comma stand behind it?
    pub comma: bool,
    /// What it is.
    pub kind: ElementKind,
}

impl Element {
    /// Without a comma.
    pub fn new(span: Span, kind: ElementKind) -> Self {
        Self { span, comma: false, kind }
    }
}

/// See the variants.
#[derive(Clone, Debug)]
pub enum ElementKind {
    /// A keyword, or the name of a built-in function without arguments.
    Word(&'static Word),
    /// A number, vector, text, name, call or a combination of them.
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
    /// A comma that stands behind no element of its sequence.
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
    /// Between two operands; `<` and `>` may also stand around a vector, `-` and `+` before an operand.
    Operator(Operator),
    /// `!`
    Not,
    /// `.`
    Dot,
    /// `?`
    Question,
    /// `:`
    Colon,
    /// A character that means nothing.
    Other,
}

/// Brackets that always are brackets.
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
    /// Both halves.
    pub fn text(self) -> [&'static str; 2] {
        match self {
            Bracket::Brace => ["{", "}"],
            Bracket::Paren => ["(", ")"],
            Bracket::Square => ["[", "]"],
        }
    }
}

/// What stands in brackets without a name.
#[derive(Clone, Debug)]
pub struct Group {
    /// Between the brackets.
    pub body: Box<[Element]>,
}

/// A name and its elements.
#[derive(Clone, Debug)]
pub struct Block {
    /// The word before the brace.
    pub name: Name,
    /// What stands between the braces.
    pub body: Box<[Element]>,
}

/// A word before a brace: a keyword, or an unknown word (an error that is reported when it is reached).
#[derive(Clone, Copy, Debug)]
pub struct Name {
    /// The keyword; `None` for a word that is none.
    pub word: Option<&'static str>,
    /// Its place.
    pub span: Span,
}

/// Literal numbers and vectors.
#[derive(Clone, Debug)]
pub struct NumberList {
    /// All numbers of all items.
    pub data: Arc<[f64]>,
    /// How many numbers each item has.
    pub widths: Widths,
}

/// How many numbers each item of a list has; 1 is a plain number.
#[derive(Clone, Debug)]
pub enum Widths {
    /// All the same.
    Uniform(u16),
    /// One for each item.
    Mixed(Arc<[u16]>),
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// All of it.
    pub span: Span,
    /// Is a name called somewhere in it? What that name is, only the run can tell.
    pub calls: bool,
    /// What it is.
    pub kind: ExprKind,
}

impl Expr {
    /// Does it compare or choose, outside of its brackets? That has a meaning only in parentheses, conditions and colours.
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

/// See the variants. Chains of operators are flat, so that no tree is deeper than the text's brackets.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A literal.
    Number(f64),
    /// A literal, escapes resolved.
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
    /// How strongly it binds: the higher, the tighter. POV-Ray 3.7 was seen to give `&` and `|` one
    /// precedence, from left to right: `(1|0&0)` is 0.
    pub fn precedence(self) -> u8 {
        use Operator::*;
        match self {
            Or | And => 1,
            Less | LessEqual | Greater | GreaterEqual | Equal | NotEqual => 3,
            Add | Sub => 4,
            Mul | Div => 5,
        }
    }

    /// The same inside `function { … }`, where `&` binds tighter than `|` (measured on POV-Ray 3.7).
    pub fn precedence_in_functions(self) -> u8 {
        if self == Operator::And { 2 } else { self.precedence() }
    }

    /// The operator that is typed so.
    pub fn of(text: &str) -> Option<Self> {
        use Operator::*;
        let all = [Add, Sub, Mul, Div, Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual, And, Or];
        all.into_iter().find(|op| op.text() == text)
    }

    /// Is it `*` or `/`?
    pub fn multiplies(self) -> bool {
        matches!(self, Operator::Mul | Operator::Div)
    }

    /// Is it `+` or `-`?
    pub fn adds(self) -> bool {
        matches!(self, Operator::Add | Operator::Sub)
    }

    /// Is it `<`, `=` or the like?
    pub fn compares(self) -> bool {
        self.precedence() == Operator::Equal.precedence()
    }

    /// As it is typed.
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

/// What a `#` begins.
#[derive(Clone, Debug)]
pub enum Directive {
    /// `#declare`, `#local`; the value is what the following elements give.
    Declare(Declare),
    /// The same where more than a name stands before the `=`, or nothing; the flag is `local`.
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
    /// Any other, by its word: what it takes are the elements that follow.
    Plain(Symbol),
}

/// What stands in parentheses behind a directive's word.
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
    /// The name, its indices and its place.
    pub target: Target,
    /// The others of `#declare (A, B) = (1, 2);`
    pub others: Box<[Target]>,
}

/// What a `#declare` gives a value.
#[derive(Clone, Debug)]
pub struct Target {
    /// The name.
    pub symbol: Symbol,
    /// Its place, without indices.
    pub span: Span,
    /// A keyword can't be declared: an error when it is reached.
    pub keyword: Option<&'static str>,
    /// `[i][j]`
    pub indices: Box<[Expr]>,
}

/// A condition and what happens where it holds.
#[derive(Clone, Debug)]
pub struct Branch {
    /// From its directive's word to the next one.
    pub span: Span,
    /// See the variants.
    pub condition: Condition,
    /// What happens.
    pub body: Box<[Element]>,
}

/// When a branch is taken.
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
    /// See [`ForHead`].
    pub head: ForHead,
    /// What is repeated.
    pub body: Box<[Element]>,
}

/// What stands in the parentheses of a `#for`.
#[derive(Clone, Debug)]
pub enum ForHead {
    /// The counter; first value, last value, perhaps a step.
    Whole(Symbol, Box<[Expr]>),
    /// Anything else; `None` if there are no parentheses.
    Pieces(Option<Box<[Element]>>),
}

/// One arm of a `#switch`.
#[derive(Clone, Debug)]
pub struct Arm {
    /// From its directive's word to the next one.
    pub span: Span,
    /// See the variants.
    pub when: When,
    /// What happens; it runs on into the next arm without `#break`.
    pub body: Box<[Element]>,
}

/// When an arm is taken.
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
    /// The name's place.
    pub span: Span,
    /// What can't be understood in its head: an error when it is reached.
    pub fault: Option<Span>,
    /// Names of its parameters; the flag is `optional`.
    pub parameters: Box<[(Symbol, bool)]>,
    /// What a call runs.
    pub body: Box<[Element]>,
}
