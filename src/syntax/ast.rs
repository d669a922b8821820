//! What is written: a sequence of elements, each with its place. Nothing is evaluated; comments are kept
//! beside the tree.

use crate::source::Span;

/// A name that the author gave, or a constant of the language; an index into [`super::Names`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// A parsed file.
#[derive(Debug, Default)]
pub struct Ast {
    /// Outermost elements.
    pub elements: Vec<Element>,
    /// Every comment, with its delimiters.
    pub comments: Vec<Span>,
}

/// Something in a file, block, entry, group, directive's body, or macro's argument list.
#[derive(Clone, Debug)]
pub struct Element {
    /// All of it.
    pub span: Span,
    /// What it is.
    pub kind: ElementKind,
}

/// See the variants.
#[derive(Clone, Debug)]
pub enum ElementKind {
    /// A keyword that opens no block.
    Word(&'static str),
    /// A number, vector, text, name, call or a combination of them.
    Expr(Box<Expr>),
    /// Two or more literal numbers and vectors with commas between them.
    Numbers(Box<NumberList>),
    /// `name { … }`.
    Block(Box<Block>),
    /// `name {` whose `}` stands in another directive's body.
    Open(Box<Name>),
    /// A `}` or `)` whose opener stands in another directive's body.
    Close,
    /// `{ … }` without a name.
    Group(Box<[Element]>),
    /// `[ … ]`.
    Entry(Box<[Element]>),
    /// `.Name :` in a dictionary.
    Key(Symbol),
    /// `:` behind `["name"]` in a dictionary.
    Colon,
    /// `(1, 2)`, what several names get at once.
    Values(Box<[Element]>),
    /// `function (…) { … }`.
    Function(Box<Function>),
    /// `;`
    Semicolon,
    /// `#…`
    Directive(Box<Directive>),
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
    pub data: Box<[f64]>,
    /// How many numbers each item has.
    pub widths: Widths,
}

/// How many numbers each item of a list has; 1 is a plain number.
#[derive(Clone, Debug)]
pub enum Widths {
    /// All the same.
    Uniform(u16),
    /// One for each item.
    Mixed(Box<[u16]>),
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// All of it.
    pub span: Span,
    /// What it is.
    pub kind: ExprKind,
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
    /// A keyword where a value belongs: an error when it is reached.
    Keyword(&'static str),
    /// `< … >` of literals only.
    Literal(Box<[f64]>),
    /// `< … >`.
    Vector(Box<[Element]>),
    /// `( … )`: kept, because `(A)` passes a copy where `A` passes a reference.
    Paren(Box<Expr>),
    /// `( #if … #end … )`.
    ParenSpliced(Box<[Element]>),
    /// Directives as an operand.
    Spliced(Box<[Element]>),
    /// `a op b op c …` of one precedence, from left to right.
    Chain(Box<Chain>),
    /// `-`, `+`, `!`.
    Prefix(Prefix, Box<Expr>),
    /// `a ? b : c`
    Choice(Box<[Expr; 3]>),
    /// A built-in function.
    Builtin(&'static str, Box<[Expr]>),
    /// A macro, user function or spline.
    Call(Symbol, Box<[Element]>),
    /// `A[i][j]`
    Index(Box<Expr>, Box<[Expr]>),
    /// `A[i](x)`
    Apply(Box<Expr>, Box<[Element]>),
    /// `A.x`
    Dot(Box<Expr>, Name, Symbol),
    /// A function as a value.
    Function(Box<Function>),
    /// A block as a value.
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

/// `function { … }`: only its syntax so far.
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
    /// `#undef`.
    Undef(Expr),
    /// `#if`, `#elseif`, `#else`.
    If(Box<[Branch]>),
    /// `#while`.
    While(Expr, Box<[Element]>),
    /// `#for`.
    For(For),
    /// `#switch`.
    Switch(Expr, Box<[Arm]>),
    /// `#break`.
    Break,
    /// `#macro`.
    Macro(Macro),
    /// `#include`.
    Include(Expr),
    /// `#version`.
    Version(Expr),
    /// `#debug`, `#warning`, `#error`, `#render`, `#statistics`.
    Message(&'static str, Expr),
    /// `#default { … }`.
    Default(Box<[Element]>),
    /// `#fopen`, `#fclose`, `#read`, `#write`.
    File(&'static str, Box<[Element]>),
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
    /// See the variants.
    pub condition: Condition,
    /// What happens.
    pub body: Box<[Element]>,
}

/// When a branch is taken.
#[derive(Clone, Debug)]
pub enum Condition {
    /// The value is not 0.
    True(Expr),
    /// The name is declared.
    Declared(Expr),
    /// The name is not declared.
    NotDeclared(Expr),
    /// `#else`.
    Always,
}

/// `#for (I, 0, 10, 1)`
#[derive(Clone, Debug)]
pub struct For {
    /// The counter.
    pub counter: Symbol,
    /// First value, last value, step.
    pub range: Box<[Expr]>,
    /// What is repeated.
    pub body: Box<[Element]>,
}

/// One arm of a `#switch`.
#[derive(Clone, Debug)]
pub struct Arm {
    /// See the variants.
    pub when: When,
    /// What happens; it runs on into the next arm without `#break`.
    pub body: Box<[Element]>,
}

/// When an arm is taken.
#[derive(Clone, Debug)]
pub enum When {
    /// `#case`.
    Case(Expr),
    /// `#range`.
    Range(Expr, Expr),
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
    /// Names of its parameters; the flag is `optional`.
    pub parameters: Box<[(Symbol, bool)]>,
    /// What a call runs.
    pub body: Box<[Element]>,
}
