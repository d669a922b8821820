//! Tokens and comments in a row, with what the tree knows of them.

/// A token, or a comment. Of a list of numbers, each number, comma and bracket is one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Atom {
    /// Its first byte.
    pub lo: u32,
    /// One past its last byte.
    pub hi: u32,
    /// Of an item of a body: the atom behind it.
    pub next: u32,
    /// Of a bracket around a body: its other half; of a directive with bodies: its [`Atoms::arms`]; of another item that holds a
    /// body: the bracket that opens it.
    pub link: u32,
    /// See [`flag`].
    pub flags: u16,
    /// What the item is that begins here.
    pub item: Item,
    /// Ends of lines before it: 2 stands for more.
    pub lines: u8,
}

/// What is known of an atom.
pub mod flag {
    /// No blank before it.
    pub const GLUE: u16 = 1;
    /// It stands on the line of what is before it.
    pub const JOIN: u16 = 1 << 1;
    /// No blank behind it: a sign, an opening bracket.
    pub const TIGHT: u16 = 1 << 2;
    /// Brackets around something.
    pub const OPEN: u16 = 1 << 3;
    /// The other half.
    pub const CLOSE: u16 = 1 << 4;
    /// An operator between two operands.
    pub const OPERATOR: u16 = 1 << 5;
    /// `// …`
    pub const LINE_COMMENT: u16 = 1 << 6;
    /// `/* … */`
    pub const BLOCK_COMMENT: u16 = 1 << 7;
    /// One of millions of vectors, blanks and all.
    pub const PACKED: u16 = 1 << 8;
    /// A bracket that has lost its other half, or holds what the tree has no name for.
    pub const LOOSE: u16 = 1 << 9;
    /// One of several textures of a declaration, which lie on each other.
    pub const LAYER: u16 = 1 << 10;
    /// Any comment.
    pub const COMMENT: u16 = LINE_COMMENT | BLOCK_COMMENT;
}
/// What begins at an atom.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Item {
    /// Nothing that stands directly in a body.
    #[default]
    None,
    /// A number, a vector, a call …
    Value,
    /// A keyword.
    Word,
    /// `name { … }`
    Block,
    /// `{ … }`
    Group,
    /// `[ … ]`
    Entry,
    /// `#declare … =`
    Declare,
    /// A directive without bodies.
    Plain,
    /// A directive with bodies.
    Bodies,
    /// `,` or `;`
    Separator,
    /// Anything else.
    Sign,
}

/// A part of a directive: `#if (A) …`.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// Its directive.
    pub head: u32,
    /// Where its body begins.
    pub body: u32,
    /// Where it ends.
    pub end: u32,
    /// Is it one of those that stand inside a `#switch`?
    pub choice: bool,
}

/// All of a text.
#[derive(Debug, Default)]
pub struct Atoms {
    /// In their order.
    pub row: Vec<Atom>,
    /// Of each directive with bodies.
    pub arms: Vec<Vec<Arm>>,
}
