//! Names that a scene uses and that are missing: one undeclared name, or the names that one missing include declares.

use crate::source::Span;

/// Action that would resolve all messages about the same missing names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// Remedy: include the file of this name, which declares the missing names.
    Include(&'static str),
    /// Remedy: declare the name, or correct its spelling.
    Declare,
}

/// Missing names that cause a message: one undeclared name, or the names that one missing include file declares.
/// Messages about the same missing names are merged.
#[derive(Clone, Debug, PartialEq)]
pub struct MissingNames {
    /// Action of the user that would declare the missing names.
    pub remedy: Remedy,
    /// Missing names, and the places where the scene uses them.
    pub uses: Vec<(String, Span)>,
}

impl MissingNames {
    /// Creates the missing names of a diagnostic, with one use of one name.
    pub fn new(remedy: Remedy, name: &str, span: Span) -> Self {
        Self { remedy, uses: vec![(name.into(), span)] }
    }

    /// True if both lack the same include file or the same undeclared name, so that their messages can be merged.
    pub fn is_same_as(&self, other: &MissingNames) -> bool {
        let first = |missing: &MissingNames| missing.uses.first().map(|(name, _)| name.clone());
        self.remedy == other.remedy && (self.remedy != Remedy::Declare || first(self) == first(other))
    }

    /// Adds the uses of other missing names, without duplicates.
    pub fn add_uses(&mut self, other: &MissingNames) {
        for part in &other.uses {
            if !self.uses.contains(part) {
                self.uses.push(part.clone());
            }
        }
    }
}
