//! What several messages have in common: a name, or an include file that declares several.

use crate::source::Span;

/// What would mend all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// This include file declares the names.
    Include(&'static str),
    /// The name has to be declared, or is misspelt.
    Declare,
}

/// Why a message is told, where others may be told for the same reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// What is to be done.
    pub remedy: Remedy,
    /// The names that are missing, and where they are used.
    pub uses: Vec<(String, Span)>,
}

impl Cause {
    /// One use of a name.
    pub fn new(remedy: Remedy, name: &str, span: Span) -> Self {
        Self { remedy, uses: vec![(name.into(), span)] }
    }

    /// Is it the same as another?
    pub fn is(&self, other: &Cause) -> bool {
        let first = |cause: &Cause| cause.uses.first().map(|(name, _)| name.clone());
        self.remedy == other.remedy && (self.remedy != Remedy::Declare || first(self) == first(other))
    }

    /// Takes over the uses of another that are not known yet.
    pub fn join(&mut self, other: &Cause) {
        for part in &other.uses {
            if !self.uses.contains(part) {
                self.uses.push(part.clone());
            }
        }
    }
}
