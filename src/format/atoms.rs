//! Units of text that the formatter places: tokens and comments as a list, with their role in the syntax tree.

/// Unit of text that the formatter places: a token or a comment. Lists of numbers are split into atoms.
#[derive(Clone, Copy, Debug, Default)]
pub struct Atom {
    /// Offset of the atom's first byte in the text.
    pub lo: u32,
    /// Offset after the atom's last byte in the text.
    pub hi: u32,
    /// Index of the atom after the item that begins at this atom, in a body.
    pub next: u32,
    /// For a bracket around a body, index of the other bracket; for a directive with bodies, index in [`Atoms::arms`];
    /// for another item with a body, index of the opening bracket.
    pub link: u32,
    /// Properties of the atom as a set of bits; see [`flag`].
    pub flags: u16,
    /// Kind of item that begins at the atom.
    pub item: ItemKind,
    /// Number of line ends before the atom, at most 2.
    pub lines: u8,
}

/// Bits for the properties of a formatter's atom.
pub mod flag {
    /// Flag: no blank precedes the atom.
    pub const NO_BLANK_BEFORE: u16 = 1;
    /// Flag: the atom is on the same line as the atom before it.
    pub const SAME_LINE: u16 = 1 << 1;
    /// Flag: no blank follows the atom, such as a sign or an opening bracket.
    pub const NO_BLANK_AFTER: u16 = 1 << 2;
    /// Flag: the atom is an opening bracket.
    pub const OPEN: u16 = 1 << 3;
    /// Flag: the atom is a closing bracket.
    pub const CLOSE: u16 = 1 << 4;
    /// Flag: the atom is a binary operator.
    pub const OPERATOR: u16 = 1 << 5;
    /// Flag: the atom is a line comment, `// …`.
    pub const LINE_COMMENT: u16 = 1 << 6;
    /// Flag: the atom is a block comment, `/* … */`.
    pub const BLOCK_COMMENT: u16 = 1 << 7;
    /// Flag: the atom is a whole vector of a very long list.
    pub const PACKED: u16 = 1 << 8;
    /// Flag: the atom is a bracket without its partner, or around contents that have no node in the tree.
    pub const UNMATCHED: u16 = 1 << 9;
    /// Flag: the atom is one of several layered textures of a declaration.
    pub const LAYER: u16 = 1 << 10;
    /// Flag: the atom is a `#` that begins no directive, or a quotation mark without its partner. Each ends its line, so
    /// that it does not become one token with the text after it.
    pub const LONE: u16 = 1 << 11;
    /// Flags of any comment, line or block.
    pub const COMMENT: u16 = LINE_COMMENT | BLOCK_COMMENT;
}
/// Kind of an item that the formatter lays out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ItemKind {
    /// Item of the formatter: none, since no item of a body begins at the atom.
    #[default]
    None,
    /// Item of the formatter: a value, such as a number, a vector or a call.
    Value,
    /// Item of the formatter: a keyword.
    Word,
    /// Item of the formatter: a block, `name { … }`.
    Block,
    /// Item of the formatter: a group without a name, `{ … }`.
    Group,
    /// Item of the formatter: a map entry, `[ … ]`.
    Entry,
    /// Item of the formatter: a declaration, `#declare … =`.
    Declare,
    /// Item of the formatter: a directive without bodies.
    Plain,
    /// Item of the formatter: a directive with bodies.
    Bodies,
    /// Item of the formatter: a separator, `,` or `;`.
    Separator,
    /// Item of the formatter: any other token.
    Sign,
}

/// Part of a directive with bodies, such as `#if (A) …`.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// Index of the atom of the arm's directive.
    pub head: u32,
    /// Index of the first atom in the arm's body.
    pub body: u32,
    /// Index of the atom after the arm's body.
    pub end: u32,
    /// True if the arms are those of a `#switch`.
    pub is_switch_arm: bool,
}

/// Atoms of a text, the units that the formatter lays out.
#[derive(Debug, Default)]
pub struct Atoms {
    /// Atoms of the text in their order.
    pub row: Vec<Atom>,
    /// Arms of each directive with bodies in the text.
    pub arms: Vec<Vec<Arm>>,
}

impl Atoms {
    /// True if a token is part of no construct: a bracket without its partner, a misplaced sign, a lone `#` or quotation mark.
    pub fn has_stray_token(&self) -> bool {
        self.row.iter().any(|atom| atom.flags & (flag::UNMATCHED | flag::LONE) != 0 || atom.item == ItemKind::Sign)
    }
}
