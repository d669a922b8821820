//! Names and what they stand for, with dynamic scope: a macro sees the `#local`s of whoever called it.
//!
//! Each symbol has its own stack of bindings (shallow binding), so that a lookup is one index.

use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{Macro, Symbol};
use crate::value::Value;
use std::rc::Rc;

/// What a name stands for.
#[derive(Clone, Debug)]
pub(in crate::interpreter) enum Slot<'a> {
    Value(Value),
    Array(Rc<Array<'a>>),
    Macro(&'a Macro),
    /// A file that `#fopen` opened, by its number.
    File(usize),
    /// A macro's parameter that was given a name or an array's element: reads and writes go there.
    Alias(LValue),
    /// What was declared could not be built; told when it is used.
    Faulty(Rc<Vec<Diagnostic>>),
}

/// An element's index, and that of the element of that array, and so on: into [`Array::items`].
type Path = Rc<[usize]>;

/// Where a value is kept.
#[derive(Clone, Debug)]
pub(in crate::interpreter) struct LValue {
    /// Whose binding it is.
    pub(in crate::interpreter) symbol: Symbol,
    /// Which of the symbol's bindings, the outermost first.
    depth: usize,
    /// The element of the array that is kept there.
    path: Option<Path>,
}

impl LValue {
    fn path(&self) -> &[usize] {
        self.path.as_deref().unwrap_or_default()
    }

    /// An element of the array that is here, or of an array in it.
    pub(in crate::interpreter) fn element(&self, indices: &[usize]) -> LValue {
        let path = self.path().iter().chain(indices).copied().collect();
        LValue { path: Some(path), ..self.clone() }
    }
}

/// `array[2][3]`: anything that can have a name, or nothing yet, in each place.
#[derive(Clone, Debug)]
pub(in crate::interpreter) struct Array<'a> {
    /// How many elements each dimension has.
    pub(in crate::interpreter) sizes: Box<[usize]>,
    /// In rows: the last index counts fastest.
    pub(in crate::interpreter) items: Vec<Option<Slot<'a>>>,
    /// Of a dictionary: what each element is called.
    pub(in crate::interpreter) keys: Option<Vec<Rc<str>>>,
}

impl Array<'_> {
    /// Has the dictionary a value of this name?
    pub(in crate::interpreter) fn has_key(&self, key: &str) -> bool {
        self.key_index(key).is_some_and(|i| self.items[i].is_some())
    }

    /// Which of a dictionary's elements is called so.
    pub(in crate::interpreter) fn key_index(&self, key: &str) -> Option<usize> {
        self.keys.iter().flatten().position(|k| **k == *key)
    }
}

impl<'a> Slot<'a> {
    /// The element at the end of a path.
    pub(in crate::interpreter) fn element(&self, path: &[usize]) -> Option<&Slot<'a>> {
        path.iter().try_fold(self, |slot, &i| match slot {
            Slot::Array(array) => array.items.get(i)?.as_ref(),
            _ => None,
        })
    }
}

/// Aliases of aliases that are followed.
const MAX_ALIASES: usize = 100;

struct Binding<'a> {
    level: u32,
    slot: Slot<'a>,
    /// Warnings about the declared thing, told where it is used.
    pending: Option<Rc<[Diagnostic]>>,
}

#[derive(Default)]
pub(in crate::interpreter) struct Scopes<'a> {
    bindings: Vec<Vec<Binding<'a>>>,
    /// The symbols bound at the levels above the global one, the outermost level's first.
    names: Vec<Symbol>,
    /// Where each level's begin.
    levels: Vec<usize>,
}

impl<'a> Scopes<'a> {
    /// The number of the innermost level; 0 is the global one.
    pub(in crate::interpreter) fn level(&self) -> u32 {
        self.levels.len() as u32
    }

    /// The number of the level at which a place's name is bound.
    pub(in crate::interpreter) fn level_of(&self, lvalue: &LValue) -> u32 {
        let binding = self.bindings.get(lvalue.symbol.0 as usize).and_then(|stack| stack.get(lvalue.depth));
        binding.map_or(0, |binding| binding.level)
    }

    pub(in crate::interpreter) fn enter(&mut self) {
        self.levels.push(self.names.len());
    }

    pub(in crate::interpreter) fn leave(&mut self) {
        let Some(start) = self.levels.pop() else { return };
        for symbol in self.names.drain(start..) {
            if let Some(stack) = self.bindings.get_mut(symbol.0 as usize) {
                stack.pop();
            }
        }
    }

    /// A level has lost one of its names.
    fn forget(&mut self, symbol: Symbol, level: u32) {
        let Some(level) = (level as usize).checked_sub(1) else { return };
        let Some(&start) = self.levels.get(level) else { return };
        let end = self.levels.get(level + 1).copied().unwrap_or(self.names.len());
        if let Some(i) = self.names[start..end].iter().rposition(|s| *s == symbol) {
            self.names.remove(start + i);
            for later in &mut self.levels[level + 1..] {
                *later -= 1;
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
    pub(in crate::interpreter) fn resolve(&self, symbol: Symbol) -> Option<LValue> {
        let (symbol, depth, path) = self.find(symbol)?;
        Some(LValue { symbol, depth, path: path.cloned() })
    }

    /// The same without a copy of the path.
    fn find(&self, symbol: Symbol) -> Option<(Symbol, usize, Option<&Path>)> {
        let depth = self.bindings.get(symbol.0 as usize)?.len().checked_sub(1)?;
        let (mut symbol, mut depth, mut path) = (symbol, depth, None);
        // An alias is made of a resolved place. Only what came there after an `#undef` can be another alias.
        for _ in 0..MAX_ALIASES {
            match &self.bindings[symbol.0 as usize].get(depth)?.slot {
                Slot::Alias(lvalue) => (symbol, depth, path) = (lvalue.symbol, lvalue.depth, lvalue.path.as_ref()),
                _ => return Some((symbol, depth, path)),
            }
        }
        None
    }

    /// A parameter of the call whose level has just been entered. Of two with one name the last counts.
    pub(in crate::interpreter) fn bind_parameter(&mut self, symbol: Symbol, slot: Slot<'a>) {
        let level = self.level();
        match self.stack(symbol).last_mut() {
            Some(binding) if binding.level == level => binding.slot = slot,
            _ => self.push(symbol, level, slot, vec![]),
        }
    }

    fn push(&mut self, symbol: Symbol, level: u32, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        self.stack(symbol).push(Binding { level, slot, pending: kept(pending) });
        // (What is bound at a level is bound at the innermost one, or at the global one.)
        if level > 0 {
            self.names.push(symbol);
        }
    }

    pub(in crate::interpreter) fn get(&self, symbol: Symbol) -> Option<&Slot<'a>> {
        let (symbol, depth, path) = self.find(symbol)?;
        let slot = &self.bindings[symbol.0 as usize][depth].slot;
        path.map_or(Some(slot), |path| slot.element(path))
    }

    /// What is at a place now.
    pub(in crate::interpreter) fn at(&self, lvalue: &LValue) -> Option<&Slot<'a>> {
        self.bindings.get(lvalue.symbol.0 as usize)?.get(lvalue.depth)?.slot.element(lvalue.path())
    }

    /// Puts something into an array's element, or takes it out.
    pub(in crate::interpreter) fn set_element(&mut self, lvalue: &LValue, slot: Option<Slot<'a>>) {
        let binding = self.bindings.get_mut(lvalue.symbol.0 as usize).and_then(|b| b.get_mut(lvalue.depth));
        let Some((binding, (last, path))) = binding.zip(lvalue.path().split_last()) else { return };
        let mut target = &mut binding.slot;
        for &i in path {
            let Slot::Array(array) = target else { return };
            let Some(Some(inner)) = Rc::make_mut(array).items.get_mut(i) else { return };
            target = inner;
        }
        if let Slot::Array(array) = target
            && let Some(item) = Rc::make_mut(array).items.get_mut(*last)
        {
            *item = slot;
        }
    }

    /// The dictionary that is kept here, if one is.
    pub(in crate::interpreter) fn dictionary(&self, lvalue: &LValue) -> Option<&Array<'a>> {
        match self.at(lvalue)? {
            Slot::Array(array) if array.keys.is_some() => Some(array),
            _ => None,
        }
    }

    /// A new element of the dictionary that is kept here, without a value yet: its index.
    pub(in crate::interpreter) fn add_key(&mut self, lvalue: &LValue, key: &str) -> usize {
        let Some(Slot::Array(array)) = self.at_mut(lvalue) else { return 0 };
        let array = Rc::make_mut(array);
        array.keys.get_or_insert_default().push(key.into());
        array.items.push(None);
        array.sizes = Box::new([array.items.len()]);
        array.items.len() - 1
    }

    fn at_mut(&mut self, lvalue: &LValue) -> Option<&mut Slot<'a>> {
        let mut slot = &mut self.bindings.get_mut(lvalue.symbol.0 as usize)?.get_mut(lvalue.depth)?.slot;
        for &i in lvalue.path() {
            let Slot::Array(array) = slot else { return None };
            slot = Rc::make_mut(array).items.get_mut(i)?.as_mut()?;
        }
        Some(slot)
    }

    /// The warnings that wait for the use of a name.
    pub(in crate::interpreter) fn pending(&self, symbol: Symbol) -> Option<Rc<[Diagnostic]>> {
        let (symbol, depth, _) = self.find(symbol)?;
        self.bindings[symbol.0 as usize][depth].pending.clone()
    }

    /// `#local`, and the parameters of a call: binds at the innermost level.
    pub(in crate::interpreter) fn set_local(&mut self, symbol: Symbol, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        let level = self.level();
        if self.stack(symbol).last().is_none_or(|b| b.level != level) {
            return self.push(symbol, level, slot, pending);
        }
        let own = self.stack(symbol).len() - 1;
        // What a parameter stood for may be gone: then it stands for itself from now on.
        match self.resolve(symbol) {
            Some(lvalue) => self.replace(&lvalue, slot, pending),
            None => self.rebind(symbol, own, slot, pending),
        }
    }

    /// `#declare`: changes the innermost binding, or makes a global one.
    pub(in crate::interpreter) fn set_global(&mut self, symbol: Symbol, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        match self.find(symbol) {
            Some((symbol, depth, None)) => self.rebind(symbol, depth, slot, pending),
            Some((symbol, depth, Some(path))) => {
                let lvalue = LValue { symbol, depth, path: Some(path.clone()) };
                self.set_element(&lvalue, Some(slot));
            }
            None => match self.stack(symbol).len() {
                0 => self.push(symbol, 0, slot, pending),
                n => self.rebind(symbol, n - 1, slot, pending),
            },
        }
    }

    fn replace(&mut self, lvalue: &LValue, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        if lvalue.path.is_none() {
            self.rebind(lvalue.symbol, lvalue.depth, slot, pending);
        } else {
            self.set_element(lvalue, Some(slot));
        }
    }

    #[inline]
    fn rebind(&mut self, symbol: Symbol, depth: usize, slot: Slot<'a>, pending: Vec<Diagnostic>) {
        let binding = &mut self.bindings[symbol.0 as usize][depth];
        (binding.slot, binding.pending) = (slot, kept(pending));
    }

    /// `#undef`: the innermost binding goes. (An alias goes, not what it stands for.)
    pub(in crate::interpreter) fn remove(&mut self, symbol: Symbol) -> bool {
        let Some(binding) = self.stack(symbol).pop() else { return false };
        self.forget(symbol, binding.level);
        true
    }

    /// What is at a place goes.
    pub(in crate::interpreter) fn unbind(&mut self, lvalue: &LValue) {
        if lvalue.path.is_some() {
            return self.set_element(lvalue, None);
        }
        let Some(stack) = self.bindings.get_mut(lvalue.symbol.0 as usize) else { return };
        if lvalue.depth < stack.len() {
            let binding = stack.remove(lvalue.depth);
            self.forget(lvalue.symbol, binding.level);
        }
    }

    /// All names that are bound now.
    pub(in crate::interpreter) fn names(&self) -> impl Iterator<Item = Symbol> + '_ {
        let bound = |(i, stack): (usize, &Vec<Binding>)| (!stack.is_empty()).then_some(Symbol(i as u32));
        self.bindings.iter().enumerate().filter_map(bound)
    }

    /// Errors in declared things that nobody used.
    pub(in crate::interpreter) fn unused_faults(&self) -> impl Iterator<Item = &Diagnostic> + '_ {
        self.bindings.iter().flatten().flat_map(|b| faults_of(&b.slot))
    }
}

#[inline]
fn kept(pending: Vec<Diagnostic>) -> Option<Rc<[Diagnostic]>> {
    if pending.is_empty() { None } else { Some(pending.into()) }
}

/// The faults of what could not be built, also in an array.
fn faults_of<'s>(slot: &'s Slot) -> Box<dyn Iterator<Item = &'s Diagnostic> + 's> {
    match slot {
        Slot::Faulty(faults) => Box::new(faults.iter()),
        Slot::Array(array) => Box::new(array.items.iter().flatten().flat_map(faults_of)),
        _ => Box::new(std::iter::empty()),
    }
}
