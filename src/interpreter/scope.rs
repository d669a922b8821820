//! Names and what they stand for, with dynamic scope: a macro sees the `#local`s of whoever called it.
//!
//! Each symbol has its own stack of bindings (shallow binding), so that a lookup is one index.

use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{Macro, Symbol};
use crate::value::Value;
use std::rc::Rc;

/// What a name stands for.
#[derive(Clone, Debug)]
pub(super) enum Slot<'a> {
    Value(Value),
    Macro(&'a Macro),
    /// A macro's parameter that was given a name: reads and writes go to that binding.
    Alias(Symbol, usize),
    /// What was declared could not be built; told when it is used.
    Faulty(Rc<Vec<Diagnostic>>),
}

/// Aliases of aliases that are followed.
const MAX_ALIASES: usize = 100;

struct Binding<'a> {
    level: u32,
    slot: Slot<'a>,
    /// Warnings about the declared thing, told where it is used.
    pending: Rc<[Diagnostic]>,
}

#[derive(Default)]
pub(super) struct Scopes<'a> {
    bindings: Vec<Vec<Binding<'a>>>,
    /// The symbols bound at each level above the global one.
    levels: Vec<Vec<Symbol>>,
}

impl<'a> Scopes<'a> {
    /// The number of the innermost level; 0 is the global one.
    pub(super) fn level(&self) -> u32 {
        self.levels.len() as u32
    }

    pub(super) fn enter(&mut self) {
        self.levels.push(vec![]);
    }

    pub(super) fn leave(&mut self) {
        for symbol in self.levels.pop().unwrap_or_default() {
            if let Some(stack) = self.bindings.get_mut(symbol.0 as usize) {
                stack.pop();
            }
        }
    }

    fn stack(&mut self, symbol: Symbol) -> &mut Vec<Binding<'a>> {
        let index = symbol.0 as usize;
        if index >= self.bindings.len() {
            self.bindings.resize_with(index + 1, Vec::new);
        }
        &mut self.bindings[index]
    }

    /// The place of the innermost binding, aliases followed; `None` too where an `#undef` has taken what an alias stood for.
    pub(super) fn resolve(&self, symbol: Symbol) -> Option<(Symbol, usize)> {
        let depth = self.bindings.get(symbol.0 as usize)?.len().checked_sub(1)?;
        let (mut symbol, mut depth) = (symbol, depth);
        // An alias is made of a resolved place. Only what came there after an `#undef` can be another alias.
        for _ in 0..MAX_ALIASES {
            match self.bindings[symbol.0 as usize].get(depth)?.slot {
                Slot::Alias(to, at) => (symbol, depth) = (to, at),
                _ => return Some((symbol, depth)),
            }
        }
        None
    }

    /// A parameter of the call whose level has just been entered. Of two with one name the last counts.
    pub(super) fn bind_parameter(&mut self, symbol: Symbol, slot: Slot<'a>) {
        let level = self.level();
        match self.stack(symbol).last_mut() {
            Some(binding) if binding.level == level => binding.slot = slot,
            _ => self.push(symbol, level, slot, vec![]),
        }
    }

    fn push(&mut self, symbol: Symbol, level: u32, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        self.stack(symbol).push(Binding { level, slot, pending: pending.into() });
        if level > 0
            && let Some(names) = self.levels.last_mut()
        {
            names.push(symbol);
        }
    }

    pub(super) fn get(&self, symbol: Symbol) -> Option<&Slot<'a>> {
        let (symbol, depth) = self.resolve(symbol)?;
        Some(&self.bindings[symbol.0 as usize][depth].slot)
    }

    /// The warnings that wait for the use of a name.
    pub(super) fn pending(&self, symbol: Symbol) -> Option<Rc<[Diagnostic]>> {
        let (symbol, depth) = self.resolve(symbol)?;
        let pending = &self.bindings[symbol.0 as usize][depth].pending;
        (!pending.is_empty()).then(|| pending.clone())
    }

    /// `#local`, and the parameters of a call: binds at the innermost level.
    pub(super) fn set_local(&mut self, symbol: Symbol, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        let level = self.level();
        if self.stack(symbol).last().is_none_or(|b| b.level != level) {
            return self.push(symbol, level, slot, pending);
        }
        let own = self.stack(symbol).len() - 1;
        // What a parameter stood for may be gone: then it stands for itself from now on.
        let (symbol, depth) = self.resolve(symbol).unwrap_or((symbol, own));
        self.replace(symbol, depth, slot, pending);
    }

    /// `#declare`: changes the innermost binding, or makes a global one.
    pub(super) fn set_global(&mut self, symbol: Symbol, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        match self.resolve(symbol) {
            Some((symbol, depth)) => self.replace(symbol, depth, slot, pending),
            None => match self.stack(symbol).len() {
                0 => self.push(symbol, 0, slot, pending),
                n => self.replace(symbol, n - 1, slot, pending),
            },
        }
    }

    fn replace(&mut self, symbol: Symbol, depth: usize, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        let binding = &mut self.bindings[symbol.0 as usize][depth];
        (binding.slot, binding.pending) = (slot, pending.into());
    }

    /// `#undef`: the innermost binding goes. (An alias goes, not what it stands for.)
    pub(super) fn remove(&mut self, symbol: Symbol) -> bool {
        let Some(binding) = self.stack(symbol).pop() else { return false };
        if binding.level > 0
            && let Some(names) = self.levels.get_mut(binding.level as usize - 1)
            && let Some(i) = names.iter().rposition(|s| *s == symbol)
        {
            names.remove(i);
        }
        true
    }

    /// All names that are bound now.
    pub(super) fn names(&self) -> impl Iterator<Item = Symbol> + '_ {
        let bound = |(i, stack): (usize, &Vec<Binding>)| (!stack.is_empty()).then_some(Symbol(i as u32));
        self.bindings.iter().enumerate().filter_map(bound)
    }

    /// Errors in declared things that nobody used.
    pub(super) fn unused_faults(&self) -> impl Iterator<Item = &Diagnostic> + '_ {
        self.bindings.iter().flatten().flat_map(|b| match &b.slot {
            Slot::Faulty(faults) => faults.iter(),
            _ => [].iter(),
        })
    }
}
