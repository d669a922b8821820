//! Scopes: names and their contents. Scope is dynamic: a macro can use the `#local` names of its caller.
//!
//! Each symbol has its own stack of bindings (shallow binding), so that a lookup is one index operation.

use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{Macro, Symbol};
use crate::value::Value;
use std::rc::Rc;

/// Contents of a declared name or an array element.
#[derive(Clone, Debug)]
pub enum Contents<'a> {
    Value(Value),
    Array(Rc<Array<'a>>),
    Macro(&'a Macro),
    /// Number of the file that `#fopen` opened under the name.
    File(usize),
    /// Location to which a macro's parameter refers, if the argument was a name or an array element.
    Alias(LValue),
    /// Faults of a declaration that failed, reported when the name is used.
    Faulty(Rc<Vec<Diagnostic>>),
}

/// Path to an element of nested arrays: its index in [`Array::items`], then the index in that element, and so on.
type Path = Rc<[usize]>;

/// An assignable location: the binding of a name, or an element of the array that is bound to the name.
#[derive(Clone, Debug)]
pub struct LValue {
    /// Name of the binding that the location starts from.
    pub symbol: Symbol,
    /// Index of the binding among those of the symbol, the outermost first.
    binding_index: usize,
    /// Path to the array element; `None` for the binding itself.
    path: Option<Path>,
}

impl LValue {
    fn path(&self) -> &[usize] {
        self.path.as_deref().unwrap_or_default()
    }

    /// Returns the location of an element of the array at this location; several indices lead into nested arrays.
    pub fn element(&self, indices: &[usize]) -> LValue {
        let path = self.path().iter().chain(indices).copied().collect();
        LValue { path: Some(path), ..self.clone() }
    }
}

/// An array, such as `array[2][3]`, or a dictionary. Elements can be anything that can have a name.
#[derive(Clone, Debug)]
pub struct Array<'a> {
    /// Number of elements in each dimension of the array.
    pub sizes: Box<[usize]>,
    /// Elements in row-major order: the last index varies fastest. `None` for an element without a value.
    pub items: Vec<Option<Contents<'a>>>,
    /// Key of each element of a dictionary; `None` for an array.
    pub keys: Option<Vec<Rc<str>>>,
}

impl Array<'_> {
    /// True if the dictionary has a value at `key`; false also for a key without a value.
    pub fn has_value_at(&self, key: &str) -> bool {
        self.key_index(key).is_some_and(|i| self.items[i].is_some())
    }

    /// Returns the index of the dictionary's element at `key`; `None` if the dictionary has no such key.
    pub fn key_index(&self, key: &str) -> Option<usize> {
        self.keys.iter().flatten().position(|k| **k == *key)
    }
}

impl<'a> Contents<'a> {
    /// Returns the element at the end of a path through nested arrays; `None` if the path leaves the arrays or the
    /// element has no value.
    pub fn element(&self, path: &[usize]) -> Option<&Contents<'a>> {
        path.iter().try_fold(self, |contents, &i| match contents {
            Contents::Array(array) => array.items.get(i)?.as_ref(),
            _ => None,
        })
    }
}

/// Maximum length of a chain of aliases that refer to each other.
const MAX_ALIASES: usize = 100;

struct Binding<'a> {
    level: u32,
    contents: Contents<'a>,
    /// Warnings about the declaration, which the first use of the name reports.
    first_use_warnings: Option<Rc<[Diagnostic]>>,
}

#[derive(Default)]
pub struct Scopes<'a> {
    bindings: Vec<Vec<Binding<'a>>>,
    /// Symbols bound at the levels above the global one, in order of their levels.
    names: Vec<Symbol>,
    /// Index in `names` at which each level begins.
    levels: Vec<usize>,
}

impl<'a> Scopes<'a> {
    /// Returns the number of the innermost level; 0 is the global level.
    pub fn level(&self) -> u32 {
        self.levels.len() as u32
    }

    /// Returns the number of the level at which the name of a location is bound.
    pub fn level_of(&self, lvalue: &LValue) -> u32 {
        let binding = self.bindings.get(lvalue.symbol.0 as usize).and_then(|stack| stack.get(lvalue.binding_index));
        binding.map_or(0, |binding| binding.level)
    }

    pub fn enter_scope(&mut self) {
        self.levels.push(self.names.len());
    }

    pub fn leave_scope(&mut self) {
        let Some(start) = self.levels.pop() else { return };
        for symbol in self.names.drain(start..) {
            if let Some(stack) = self.bindings.get_mut(symbol.0 as usize) {
                stack.pop();
            }
        }
    }

    /// Removes a name from the list of the names that are bound at a scope level. The binding itself stays.
    fn remove_from_name_list(&mut self, symbol: Symbol, level: u32) {
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

    fn binding_stack(&mut self, symbol: Symbol) -> &mut Vec<Binding<'a>> {
        let index = symbol.0 as usize;
        if index >= self.bindings.len() {
            self.bindings.resize_with(index + 1, Vec::new);
        }
        &mut self.bindings[index]
    }

    /// Returns the location of a name's innermost binding, after following aliases; `None` for a name that is not
    /// bound, or whose alias has lost its target.
    pub fn resolve(&self, symbol: Symbol) -> Option<LValue> {
        let (symbol, binding_index, path) = self.symbol_binding_and_path(symbol)?;
        Some(LValue { symbol, binding_index, path: path.cloned() })
    }

    /// Returns the location of a name that is bound at `level`; a location without contents if the name is not.
    pub fn resolve_at(&self, symbol: Symbol, level: u32) -> LValue {
        let stack = self.bindings.get(symbol.0 as usize).map_or(&[][..], Vec::as_slice);
        let bound = stack.iter().rposition(|binding| binding.level == level);
        match bound.and_then(|binding_index| self.follow_aliases_from(symbol, binding_index)) {
            Some((symbol, binding_index, path)) => LValue { symbol, binding_index, path: path.cloned() },
            None => LValue { symbol, binding_index: usize::MAX, path: None },
        }
    }

    /// Returns the parts of the location that [`Self::resolve`] returns, without copying the path.
    fn symbol_binding_and_path(&self, symbol: Symbol) -> Option<(Symbol, usize, Option<&Path>)> {
        let binding_index = self.bindings.get(symbol.0 as usize)?.len().checked_sub(1)?;
        self.follow_aliases_from(symbol, binding_index)
    }

    /// Follows the aliases that begin at the binding with the index `binding_index` of a symbol; `None` if the target
    /// is lost or the aliases form a circle.
    fn follow_aliases_from(&self, symbol: Symbol, binding_index: usize) -> Option<(Symbol, usize, Option<&Path>)> {
        let (mut symbol, mut binding_index, mut path) = (symbol, binding_index, None);
        // An alias is made from a resolved location. Its target can be another alias only after an `#undef`.
        for _ in 0..MAX_ALIASES {
            match &self.bindings[symbol.0 as usize].get(binding_index)?.contents {
                Contents::Alias(lvalue) => {
                    (symbol, binding_index, path) = (lvalue.symbol, lvalue.binding_index, lvalue.path.as_ref())
                }
                _ => return Some((symbol, binding_index, path)),
            }
        }
        None
    }

    /// Binds a parameter at the level that was just entered. Of two parameters with one name, the last is bound.
    pub fn bind_parameter(&mut self, symbol: Symbol, contents: Contents<'a>) {
        let level = self.level();
        match self.binding_stack(symbol).last_mut() {
            Some(binding) if binding.level == level => binding.contents = contents,
            _ => self.push(symbol, level, contents, vec![]),
        }
    }

    fn push(&mut self, symbol: Symbol, level: u32, contents: Contents<'a>, first_use_warnings: Vec<Diagnostic>) {
        self.binding_stack(symbol).push(Binding { level, contents, first_use_warnings: non_empty(first_use_warnings) });
        // A binding is made at the innermost level or at the global one.
        if level > 0 {
            self.names.push(symbol);
        }
    }

    /// Returns the contents of a name's innermost binding, after following aliases; `None` if the name is not bound or
    /// an aliased element has no value.
    #[inline]
    pub fn get(&self, symbol: Symbol) -> Option<&Contents<'a>> {
        match &self.bindings.get(symbol.0 as usize)?.last()?.contents {
            Contents::Alias(_) => self.aliased_contents(symbol),
            contents => Some(contents),
        }
    }

    fn aliased_contents(&self, symbol: Symbol) -> Option<&Contents<'a>> {
        let (symbol, binding_index, path) = self.symbol_binding_and_path(symbol)?;
        let contents = &self.bindings[symbol.0 as usize][binding_index].contents;
        path.map_or(Some(contents), |path| contents.element(path))
    }

    /// Returns the contents of a location; `None` if the location has no value.
    pub fn contents_at(&self, lvalue: &LValue) -> Option<&Contents<'a>> {
        self.bindings.get(lvalue.symbol.0 as usize)?.get(lvalue.binding_index)?.contents.element(lvalue.path())
    }

    /// Sets an array element, or clears it if `contents` is `None`. Does nothing if the location is no array element.
    pub fn set_element(&mut self, lvalue: &LValue, contents: Option<Contents<'a>>) {
        let binding = self.bindings.get_mut(lvalue.symbol.0 as usize).and_then(|b| b.get_mut(lvalue.binding_index));
        let Some((binding, (last, path))) = binding.zip(lvalue.path().split_last()) else { return };
        let mut target = &mut binding.contents;
        for &i in path {
            let Contents::Array(array) = target else { return };
            let Some(Some(inner)) = Rc::make_mut(array).items.get_mut(i) else { return };
            target = inner;
        }
        if let Contents::Array(array) = target
            && let Some(item) = Rc::make_mut(array).items.get_mut(*last)
        {
            *item = contents;
        }
    }

    /// Returns the dictionary at an assignable location; `None` if another value or none is at the location.
    pub fn dictionary(&self, lvalue: &LValue) -> Option<&Array<'a>> {
        match self.contents_at(lvalue)? {
            Contents::Array(array) if array.keys.is_some() => Some(array),
            _ => None,
        }
    }

    /// Adds an element without a value to the dictionary at a location, and returns its index.
    pub fn add_key(&mut self, dictionary: &LValue, key: &str) -> usize {
        let Some(Contents::Array(array)) = self.at_mut(dictionary) else { return 0 };
        let array = Rc::make_mut(array);
        array.keys.get_or_insert_default().push(key.into());
        array.items.push(None);
        array.sizes = Box::new([array.items.len()]);
        array.items.len() - 1
    }

    fn at_mut(&mut self, lvalue: &LValue) -> Option<&mut Contents<'a>> {
        let mut contents =
            &mut self.bindings.get_mut(lvalue.symbol.0 as usize)?.get_mut(lvalue.binding_index)?.contents;
        for &i in lvalue.path() {
            let Contents::Array(array) = contents else { return None };
            contents = Rc::make_mut(array).items.get_mut(i)?.as_mut()?;
        }
        Some(contents)
    }

    /// Returns the warnings about a name's declaration that the first use of the name is to report; `None` without any.
    pub fn pending_warnings(&self, symbol: Symbol) -> Option<Rc<[Diagnostic]>> {
        let (symbol, binding_index, _) = self.symbol_binding_and_path(symbol)?;
        self.bindings[symbol.0 as usize][binding_index].first_use_warnings.clone()
    }

    /// Binds a name at the innermost level, as `#local` does. If the name is a parameter that refers to a location of
    /// the caller, this location is set instead.
    pub fn set_local(&mut self, symbol: Symbol, contents: Contents<'a>, first_use_warnings: Vec<Diagnostic>) {
        let level = self.level();
        if self.binding_stack(symbol).last().is_none_or(|b| b.level != level) {
            return self.push(symbol, level, contents, first_use_warnings);
        }
        let own = self.binding_stack(symbol).len() - 1;
        // If the target of a parameter's alias is gone, the parameter becomes a binding of its own.
        match self.resolve(symbol) {
            Some(lvalue) => self.replace(&lvalue, contents, first_use_warnings),
            None => self.rebind(symbol, own, contents, first_use_warnings),
        }
    }

    /// Binds a name to a number, as [`Self::set_local`] does if `is_local` is true, and
    /// [`Self::rebind_innermost_or_add_global`] otherwise. (Loops mostly change numbers, in place.)
    #[inline]
    pub fn set_number(&mut self, symbol: Symbol, number: f64, is_local: bool) {
        let level = self.level();
        let innermost = self.bindings.get_mut(symbol.0 as usize).and_then(|stack| stack.last_mut());
        let contents = Contents::Value(Value::Float(number));
        match innermost {
            Some(Binding { level: own, contents: Contents::Value(Value::Float(old)), first_use_warnings: None })
                if !is_local || *own == level =>
            {
                *old = number;
            }
            _ if is_local => self.set_local(symbol, contents, vec![]),
            _ => self.rebind_innermost_or_add_global(symbol, contents, vec![]),
        }
    }

    /// Changes the innermost binding of a name, or the location that it is an alias of, as `#declare` does. A name
    /// without a binding gets a global one.
    pub fn rebind_innermost_or_add_global(
        &mut self,
        symbol: Symbol,
        contents: Contents<'a>,
        first_use_warnings: Vec<Diagnostic>,
    ) {
        // (Mostly the innermost binding is no alias.)
        if let Some(binding) = self.bindings.get_mut(symbol.0 as usize).and_then(|stack| stack.last_mut())
            && !matches!(binding.contents, Contents::Alias(_))
        {
            (binding.contents, binding.first_use_warnings) = (contents, non_empty(first_use_warnings));
            return;
        }
        match self.symbol_binding_and_path(symbol) {
            Some((symbol, binding_index, None)) => self.rebind(symbol, binding_index, contents, first_use_warnings),
            Some((symbol, binding_index, Some(path))) => {
                let lvalue = LValue { symbol, binding_index, path: Some(path.clone()) };
                self.set_element(&lvalue, Some(contents));
            }
            None => match self.binding_stack(symbol).len() {
                0 => self.push(symbol, 0, contents, first_use_warnings),
                n => self.rebind(symbol, n - 1, contents, first_use_warnings),
            },
        }
    }

    /// Binds a name at `level`, as `#declare global.A` and `#declare local.A` (3.8) do.
    pub fn set_at_level(
        &mut self,
        symbol: Symbol,
        level: u32,
        contents: Contents<'a>,
        first_use_warnings: Vec<Diagnostic>,
    ) {
        if level == self.level() {
            return self.set_local(symbol, contents, first_use_warnings);
        }
        let stack = self.binding_stack(symbol);
        match stack.iter().position(|binding| binding.level >= level) {
            Some(binding_index) if stack[binding_index].level == level => {
                self.rebind(symbol, binding_index, contents, first_use_warnings)
            }
            Some(binding_index) => {
                stack.insert(
                    binding_index,
                    Binding { level, contents, first_use_warnings: non_empty(first_use_warnings) },
                );
                self.shift_aliases_after_insertion(symbol, binding_index);
            }
            None => self.push(symbol, level, contents, first_use_warnings),
        }
    }

    /// Corrects the aliases of a symbol's bindings after another binding was inserted at this place of the stack.
    fn shift_aliases_after_insertion(&mut self, symbol: Symbol, inserted_at: usize) {
        for binding in self.bindings.iter_mut().flatten() {
            if let Contents::Alias(lvalue) = &mut binding.contents
                && lvalue.symbol == symbol
                && lvalue.binding_index >= inserted_at
            {
                lvalue.binding_index += 1;
            }
        }
    }

    fn replace(&mut self, lvalue: &LValue, contents: Contents<'a>, first_use_warnings: Vec<Diagnostic>) {
        if lvalue.path.is_none() {
            self.rebind(lvalue.symbol, lvalue.binding_index, contents, first_use_warnings);
        } else {
            self.set_element(lvalue, Some(contents));
        }
    }

    #[inline]
    fn rebind(
        &mut self,
        symbol: Symbol,
        binding_index: usize,
        contents: Contents<'a>,
        first_use_warnings: Vec<Diagnostic>,
    ) {
        let binding = &mut self.bindings[symbol.0 as usize][binding_index];
        (binding.contents, binding.first_use_warnings) = (contents, non_empty(first_use_warnings));
    }

    /// Removes the innermost binding of a name, as `#undef` does. If the name is an alias, its target stays. Returns
    /// false if the name had no binding.
    pub fn remove(&mut self, symbol: Symbol) -> bool {
        let Some(binding) = self.binding_stack(symbol).pop() else { return false };
        self.remove_from_name_list(symbol, binding.level);
        true
    }

    /// Removes the binding or the array element at a location.
    pub fn unbind(&mut self, lvalue: &LValue) {
        if lvalue.path.is_some() {
            return self.set_element(lvalue, None);
        }
        let Some(stack) = self.bindings.get_mut(lvalue.symbol.0 as usize) else { return };
        if lvalue.binding_index < stack.len() {
            let binding = stack.remove(lvalue.binding_index);
            self.remove_from_name_list(lvalue.symbol, binding.level);
        }
    }

    /// Returns all names that are bound at present.
    pub fn names(&self) -> impl Iterator<Item = Symbol> + '_ {
        let bound = |(i, stack): (usize, &Vec<Binding>)| (!stack.is_empty()).then_some(Symbol(i as u32));
        self.bindings.iter().enumerate().filter_map(bound)
    }

    /// Returns the faults of all failed declarations that are bound at present, whether the scene has used the names or
    /// not.
    pub fn faults_of_failed_declarations(&self) -> impl Iterator<Item = &Diagnostic> + '_ {
        self.bindings.iter().flatten().flat_map(|b| faults_of(&b.contents))
    }
}

#[inline]
fn non_empty(first_use_warnings: Vec<Diagnostic>) -> Option<Rc<[Diagnostic]>> {
    if first_use_warnings.is_empty() { None } else { Some(first_use_warnings.into()) }
}

/// Returns the faults of failed declarations in a name's contents, including those in arrays.
fn faults_of<'s>(contents: &'s Contents) -> Box<dyn Iterator<Item = &'s Diagnostic> + 's> {
    match contents {
        Contents::Faulty(faults) => Box::new(faults.iter()),
        Contents::Array(array) => Box::new(array.items.iter().flatten().flat_map(faults_of)),
        _ => Box::new(std::iter::empty()),
    }
}
