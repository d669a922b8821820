//! Tokens and comments as a list, with their role in the tree.

/// A token, or a comment. Each number, comma and bracket of a list of numbers is an atom.
#[derive(Clone, Copy, Debug, Default)]
pub struct Atom {
    /// Offset of the first byte.
    pub lo: u32,
    /// Offset after the last byte.
    pub hi: u32,
    /// For an item of a body: index of the atom after the item.
    pub next: u32,
    /// For a bracket around a body: the other bracket; for a directive with bodies: its index in [`Atoms::arms`]; for
    /// another item with a body: the opening bracket.
    pub link: u32,
    /// See [`flag`].
    pub flags: u16,
    /// The kind of item that begins here.
    pub item: Item,
    /// Number of line ends before the atom, at most 2.
    pub lines: u8,
}

/// Properties of an atom.
pub mod flag {
    /// No blank precedes it.
    pub const GLUE: u16 = 1;
    /// It is on the same line as the atom before it.
    pub const JOIN: u16 = 1 << 1;
    /// No blank follows it: a sign, an opening bracket.
    pub const TIGHT: u16 = 1 << 2;
    /// An opening bracket.
    pub const OPEN: u16 = 1 << 3;
    /// A closing bracket.
    pub const CLOSE: u16 = 1 << 4;
    /// An operator between two operands.
    pub const OPERATOR: u16 = 1 << 5;
    /// `// …`
    pub const LINE_COMMENT: u16 = 1 << 6;
    /// `/* … */`
    pub const BLOCK_COMMENT: u16 = 1 << 7;
    /// One vector of a very long list, as one atom.
    pub const PACKED: u16 = 1 << 8;
    /// A bracket without its other half, or around contents that the tree has no node for.
    pub const LOOSE: u16 = 1 << 9;
    /// One of several layered textures of a declaration.
    pub const LAYER: u16 = 1 << 10;
    /// Any comment.
    pub const COMMENT: u16 = LINE_COMMENT | BLOCK_COMMENT;
}
/// Kinds of items.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Item {
    /// No direct item of a body.
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
    /// The atom of its directive.
    pub head: u32,
    /// First atom of its body.
    pub body: u32,
    /// Atom after its body.
    pub end: u32,
    /// True for the arms of a `#switch`.
    pub choice: bool,
}

/// The atoms of a text.
#[derive(Debug, Default)]
pub struct Atoms {
    /// In the order of the text.
    pub row: Vec<Atom>,
    /// The arms of each directive with bodies.
    pub arms: Vec<Vec<Arm>>,
}
