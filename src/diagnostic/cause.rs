//! The common cause of several messages: an undeclared name, or a missing include file that declares several names.

use crate::source::Span;

/// Action that would resolve all messages with one cause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// Remedy: include the file of this name, which declares the missing names.
    Include(&'static str),
    /// Remedy: declare the name, or correct its spelling.
    Declare,
}

/// The cause of a message, which other messages may share.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// Action of the user that would resolve the messages with this cause.
    pub remedy: Remedy,
    /// Missing names, and the places where the scene uses them.
    pub uses: Vec<(String, Span)>,
}

impl Cause {
    /// Creates a diagnostic's cause with one use of a name.
    pub fn new(remedy: Remedy, name: &str, span: Span) -> Self {
        Self { remedy, uses: vec![(name.into(), span)] }
    }

    /// True if both causes have the same remedy and names, so that their messages can be merged.
    pub fn is_same_as(&self, other: &Cause) -> bool {
        let first = |cause: &Cause| cause.uses.first().map(|(name, _)| name.clone());
        self.remedy == other.remedy && (self.remedy != Remedy::Declare || first(self) == first(other))
    }

    /// Adds the uses of names in another cause, without duplicates.
    pub fn add_uses(&mut self, other: &Cause) {
        for part in &other.uses {
            if !self.uses.contains(part) {
                self.uses.push(part.clone());
            }
        }
    }
}
