//! Table of interned names.

use super::ast::Symbol;
use rustc_hash::FxHashMap;
use std::cell::RefCell;

/// The table of all names in all files of a run.
#[derive(Default)]
pub struct Names {
    texts: elsa::FrozenVec<Box<str>>,
    symbols: RefCell<FxHashMap<Box<str>, Symbol>>,
}

impl Names {
    /// Returns the symbol of a name, and adds the name to the table if it is new.
    pub fn intern(&self, name: &str) -> Symbol {
        let mut symbols = self.symbols.borrow_mut();
        if let Some(&symbol) = symbols.get(name) {
            return symbol;
        }
        let symbol = Symbol(self.texts.len() as u32);
        self.texts.push(name.into());
        symbols.insert(name.into(), symbol);
        symbol
    }

    /// Returns the symbol of a name; `None` if no file mentions the name.
    pub fn find(&self, name: &str) -> Option<Symbol> {
        self.symbols.borrow().get(name).copied()
    }

    /// Returns the name of a symbol.
    pub fn text(&self, symbol: Symbol) -> &str {
        &self.texts[symbol.0 as usize]
    }

    /// Returns the number of names in the symbol table.
    pub fn len(&self) -> usize {
        self.texts.len()
    }

    /// True if the symbol table has no names.
    pub fn is_empty(&self) -> bool {
        self.texts.len() == 0
    }
}
