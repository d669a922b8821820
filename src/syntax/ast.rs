//! The syntax tree of a scene's text: a sequence of elements with their spans. Nothing is evaluated; a list beside the
//! tree holds the tokens and comments.

pub use super::number_list::{NumberList, Numbers, Widths};
use super::tokens::Tokens;
use super::word::Word;
use crate::source::Span;

/// Number of a name in [`super::Names`]: a name that the author chose, or a constant of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// Syntax tree of a scene file, which may contain faults.
#[derive(Debug, Default)]
pub struct Ast {
    /// Outermost elements of the scene file.
    pub elements: Vec<Element>,
    /// All tokens and comments of the file. With the blanks between them, they are the file's whole text.
    pub tokens: Tokens,
    /// Brackets that are not closed in the rest of the file.
    pub unclosed: Vec<Span>,
}

/// Syntax element of a file, block, map entry, group, directive's body, or macro's argument list.
#[derive(Clone, Debug)]
pub struct Element {
    /// Span of the syntax element in the source.
    pub span: Span,
    /// True if a comma follows the element.
    pub comma: bool,
    /// Kind of the syntax element.
    pub kind: ElementKind,
}

impl Element {
    /// Creates a syntax element that no comma follows.
    pub fn new(span: Span, kind: ElementKind) -> Self {
        Self { span, comma: false, kind }
    }
}

/// Kinds of elements in a scene's syntax tree.
#[derive(Clone, Debug)]
pub enum ElementKind {
    /// A keyword, or the name of a built-in function without arguments.
    Word(&'static Word),
    /// A number, vector, string, name or call, or operators between these.
    Expr(Box<Expr>),
    /// Two or more literal numbers and vectors with commas between them.
    Numbers(Box<NumberList>),
    /// Element of the form `name { … }`, such as `sphere { … }`.
    Block(Box<Block>),
    /// Element of the form `{ … }`, without a name.
    Group(Box<Group>),
    /// Element of the form `[ … ]`, such as a color map's entry.
    Entry(Box<Group>),
    /// Element of the form `function (…) { … }`.
    Function(Box<Function>),
    /// Element that is a directive, `#…`.
    Directive(Box<Directive>),
    /// Element that is a lone `;`.
    Semicolon,
    /// A comma that follows no element of its sequence.
    Comma,
    /// Any other token: an operator without its operands, a bracket without its partner.
    Punctuation(Punctuation),
}

/// A token that is neither a word nor a literal: a bracket, an operator, or another mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Punctuation {
    /// Opening bracket without its partner.
    Open(Bracket),
    /// Closing bracket without its partner.
    Close(Bracket),
    /// Binary operator. `<` and `>` may also enclose a vector, and `-` and `+` may precede an operand.
    Operator(Operator),
    /// The mark `!`.
    Not,
    /// The mark `.`.
    Dot,
    /// The mark `?`.
    Question,
    /// The mark `:`.
    Colon,
    /// Character without meaning in the scene language.
    Other,
}

/// Brackets other than `<` and `>`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bracket {
    /// A pair of braces, `{ }`.
    Brace,
    /// A pair of parentheses, `( )`.
    Paren,
    /// A pair of square brackets, `[ ]`.
    Square,
}

impl Bracket {
    /// Returns the opening and the closing bracket as texts.
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
    /// Elements between the brackets of a group.
    pub body: Box<[Element]>,
}

/// A block's name and the elements between its braces.
#[derive(Clone, Debug)]
pub struct Block {
    /// The word before the block's opening brace.
    pub name: Name,
    /// The elements between the block's braces.
    pub body: Box<[Element]>,
}

/// A block's name before `{`, or the name after a `.`, as in `A.x`: a keyword, or another word (before `{` an error
/// that is reported when the run reaches it).
#[derive(Clone, Copy, Debug)]
pub struct Name {
    /// Keyword that the name is; `None` for a word that is not in the scene language.
    pub word: Option<&'static str>,
    /// Span of the word: a block's name before `{`, or the name after a `.`, as in `A.x`.
    pub span: Span,
}

/// An expression of the syntax tree.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Span of the expression in the source.
    pub span: Span,
    /// True if a name is called somewhere in the expression. Only the run decides whether the name is a macro.
    pub calls: bool,
    /// Kind of the expression.
    pub kind: ExprKind,
}

impl Expr {
    /// True if the expression contains a comparison, `&`, `|` or `?:` outside of brackets. All of them have a meaning
    /// only in parentheses, conditions and colours.
    pub fn has_bare_condition(&self) -> bool {
        match &self.kind {
            ExprKind::Chain(chain) => {
                let op = chain.rest.first().map(|(op, _)| *op);
                op.is_some_and(|op| !op.is_addition_or_subtraction() && !op.is_multiplication_or_division())
            }
            ExprKind::Choice(_) => true,
            _ => false,
        }
    }
}

/// Kinds of expressions. A chain of operators is one flat node, so the tree is never deeper than the text's brackets.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// Expression that is a literal number.
    Number(f64),
    /// Expression that is a string literal, with its escapes resolved.
    Text(Box<str>),
    /// Expression that is a declared name or constant.
    Name(Symbol),
    /// Expression that is a vector `< … >` of literals only.
    Literal(Numbers),
    /// Expression that is a vector `< … >` of expressions.
    Vector(Box<[Element]>),
    /// Expression in parentheses, `( … )`. A macro receives a copy for `(A)` and a reference for `A`.
    Paren(Box<Expr>),
    /// Chain of binary operators of one precedence, `a op b op c …`, from left to right.
    Chain(Box<Chain>),
    /// Expression with a prefix operator: `-`, `+` or `!`.
    Prefix(Prefix, Box<Expr>),
    /// Conditional expression `a ? b : c`.
    Choice(Box<[Expr; 3]>),
    /// Expression that calls a built-in function.
    Builtin(&'static Word, Box<[Expr]>),
    /// Expression that calls a macro, user function or spline.
    Call(Symbol, Box<[Element]>),
    /// Expression that accesses an array: `A[i][j]`.
    Index(Box<Expr>, Box<[Expr]>),
    /// Expression that calls an element of an array: `A[i](x)`.
    Apply(Box<Expr>, Box<[Element]>),
    /// Expression that accesses a component `V.x`, an element `D.Key` of a dictionary, or `local.A`.
    Dot(Box<Expr>, Name, Symbol),
    /// A function definition as an argument of an expression.
    Function(Box<Function>),
    /// A block as an argument of an expression.
    Block(Box<Block>),
}

/// Operands and the operators between them.
#[derive(Clone, Debug)]
pub struct Chain {
    /// First operand of a chain of binary operators.
    pub first: Expr,
    /// Operators and operands after the chain's first operand.
    pub rest: Box<[(Operator, Expr)]>,
}

/// Prefix operator of an expression: sign or negation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// The prefix operator `-`.
    Minus,
    /// The prefix operator `+`.
    Plus,
    /// The prefix operator `!`.
    Not,
}

/// Binary operator of an expression.
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
    /// Returns the operator's precedence: a higher number binds more tightly. `&` and `|` have one precedence, from
    /// left to right: `(1|0&0)` is 0 (quirk: `logical_precedence`).
    pub fn precedence(self) -> u8 {
        use Operator::*;
        match self {
            Or | And => 1,
            Less | LessEqual | Greater | GreaterEqual | Equal | NotEqual => 3,
            Add | Sub => 4,
            Mul | Div => 5,
        }
    }

    /// Returns the operator's precedence inside `function { … }`, where `&` binds more tightly than `|` (quirk:
    /// `logical_precedence`).
    pub fn precedence_in_functions(self) -> u8 {
        if self == Operator::And { 2 } else { self.precedence() }
    }

    /// Returns the binary operator with the spelling `text`; `None` for any other text.
    pub fn from_text(text: &str) -> Option<Self> {
        use Operator::*;
        let all = [Add, Sub, Mul, Div, Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual, And, Or];
        all.into_iter().find(|op| op.text() == text)
    }

    /// True for the binary operators `*` and `/`.
    pub fn is_multiplication_or_division(self) -> bool {
        matches!(self, Operator::Mul | Operator::Div)
    }

    /// True for the binary operators `+` and `-`.
    pub fn is_addition_or_subtraction(self) -> bool {
        matches!(self, Operator::Add | Operator::Sub)
    }

    /// True for comparison operators such as `<`.
    pub fn is_comparison(self) -> bool {
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

/// A function definition, `function { … }`.
#[derive(Clone, Debug)]
pub struct Function {
    /// The names in parentheses; empty means `x, y, z`.
    pub parameters: Box<[Symbol]>,
    /// Size of a height field's function, as in `function 200, 200 { … }`.
    pub size: Box<[Expr]>,
    /// Contents of the function: expressions, blocks such as `pigment { … }`, and directives.
    pub body: Box<[Element]>,
}

/// A directive of the scene language, such as `#if`, with its contents.
#[derive(Clone, Debug)]
pub enum Directive {
    /// Directive `#declare` or `#local`; the value is the result of the following elements.
    Declare(Declare),
    /// Directive `#declare` or `#local` with anything but a plain target before the `=`. The flag is true for `#local`.
    DeclarePieces(bool),
    /// The directive `#if` with its `#elseif` and `#else` branches.
    If(Box<[Branch]>),
    /// The directive `#while` with its condition and body.
    While(Head, Box<[Element]>),
    /// The directive `#for` with its counter and body.
    For(For),
    /// The directive `#switch` with its value and arms.
    Switch(Head, Box<[Arm]>),
    /// The directive `#macro` with its definition.
    Macro(Macro),
    /// Any other directive, by its word: its arguments are the elements that follow.
    Plain(Symbol),
}

/// The parentheses after a directive's word.
#[derive(Clone, Debug)]
pub enum Head {
    /// Contents of the parentheses, if they are one complete expression.
    Whole(Expr),
    /// Contents of the parentheses, if they are no complete expression; `None` if there are no parentheses.
    Pieces(Option<Box<[Element]>>),
}

/// The directive `#declare A[i] =` or `#local A[i] =`, without the value that follows.
#[derive(Clone, Debug)]
pub struct Declare {
    /// True for `#local`, false for `#declare`.
    pub local: bool,
    /// Message of `deprecated "why"` in a declaration; `None` without `deprecated`. The flag is true for `deprecated
    /// once`.
    pub deprecated: Option<(bool, Box<str>)>,
    /// Name that the declaration assigns to, with its indices and its span.
    pub target: Target,
    /// The other targets of `#declare (A, B) = (1, 2);`
    pub others: Box<[Target]>,
}

/// Target of a `#declare` directive: a name with optional indices.
#[derive(Clone, Debug)]
pub struct Target {
    /// Name that a `#declare` directive assigns to.
    pub symbol: Symbol,
    /// Span of the declared name, without its indices.
    pub span: Span,
    /// Keyword in place of the name, which is an error once the directive runs; `None` for a proper name.
    pub keyword: Option<&'static str>,
    /// Indices `[i][j]` after the declared name.
    pub indices: Box<[Expr]>,
}

/// One branch of an `#if` directive: a condition, and the elements that run if the condition holds.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Span of the branch from its directive's word to the next one.
    pub span: Span,
    /// Condition of an `#if` directive's branch.
    pub condition: Condition,
    /// Elements that run if the branch's condition holds.
    pub body: Box<[Element]>,
}

/// Condition of an `#if` directive's branch.
#[derive(Clone, Debug)]
pub enum Condition {
    /// Condition that holds if the value is not 0.
    True(Head),
    /// Condition `#ifdef`, which holds if the name is declared.
    Declared(Head),
    /// Condition `#ifndef`, which holds if the name is not declared.
    NotDeclared(Head),
    /// Condition of `#else`, which always holds.
    Always,
}

/// The directive `#for (I, 0, 10, 1)` with its body.
#[derive(Clone, Debug)]
pub struct For {
    /// Counter and range of the `#for` loop.
    pub head: ForHead,
    /// Elements in the body of the `#for` loop.
    pub body: Box<[Element]>,
}

/// Contents of the parentheses after `#for`.
#[derive(Clone, Debug)]
pub enum ForHead {
    /// The counter; first value, last value, and an optional step.
    Whole(Symbol, Box<[Expr]>),
    /// Contents of the `#for` parentheses that are no plain range; `None` if there are no parentheses.
    Pieces(Option<Box<[Element]>>),
}

/// One arm of a `#switch` directive: `#case`, `#range` or `#else`.
#[derive(Clone, Debug)]
pub struct Arm {
    /// Span of the arm from its directive's word to the next one.
    pub span: Span,
    /// Condition of the `#switch` arm.
    pub when: When,
    /// Elements that run if the arm is chosen. Without `#break`, the next arm runs too.
    pub body: Box<[Element]>,
}

/// Condition of a `#switch` directive's arm.
#[derive(Clone, Debug)]
pub enum When {
    /// Condition `#case`: the switch value equals this value.
    Case(Head),
    /// Condition `#range`: the switch value is between two ends, both included. Contents of the parentheses with the
    /// ends; `None` if there are no parentheses.
    Range(Option<Box<[Element]>>),
    /// Condition of the `#else` arm, which holds if no other arm does.
    Otherwise,
}

/// The directive `#macro Name(A, B)` with its body.
#[derive(Clone, Debug)]
pub struct Macro {
    /// Name of the macro.
    pub name: Symbol,
    /// Span of the macro's name.
    pub span: Span,
    /// Span of a fault between `#macro` and its body, which is an error once the directive runs; `None` without a
    /// fault.
    pub fault: Option<Span>,
    /// Names of the macro's parameters. The flag is true for an `optional` parameter.
    pub parameters: Box<[(Symbol, bool)]>,
    /// Elements that a call of the macro runs.
    pub body: Box<[Element]>,
}

impl Macro {
    /// Returns the value that is the macro's whole body, such as `abs(A - B)` or `(A + B)`, if no text around a call can
    /// change how it is read: operators before and after `A + B` could, and a name could be passed by reference. A macro
    /// with such a body is called a value macro.
    pub fn value(&self) -> Option<&Expr> {
        match &*self.body {
            [Element { kind: ElementKind::Expr(e), comma: false, .. }] => {
                matches!(e.kind, ExprKind::Builtin(..) | ExprKind::Paren(_) | ExprKind::Vector(_)).then_some(&**e)
            }
            _ => None,
        }
    }
}
