//! `array[2][3] { … }` and its elements (manual, "Arrays").

use super::Interpreter;
use super::scope::{Array, Place, Slot};
use super::stream::Token;
use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::source::Span;
use crate::syntax::ast::{Element, ElementKind, Expr, ExprKind, Symbol};
use crate::value::{Reader, Value};
use std::rc::Rc;

/// The most elements that an array may have.
const MAX_ELEMENTS: usize = 50_000_000;
/// The most dimensions: POV-Ray has five.
const MAX_DIMENSIONS: usize = 5;

impl<'a> Interpreter<'a> {
    /// `array[2][3] { {1, 2, 3}, {4, 5, 6} }`; the word comes next. Without sizes they are those of the braces (3.8).
    pub(super) fn array(&mut self) -> Result<Slot<'a>> {
        let span = self.here();
        self.advance();
        let mut sizes = vec![];
        // 3.8 asks for the word `mixed` where kinds are mixed; nobody needs it here.
        if let Some(ElementKind::Expr(e)) = self.frames.last().and_then(|f| f.elements.get(f.at)).map(|e| &e.kind) {
            match &e.kind {
                ExprKind::Name(symbol) if self.names.text(*symbol) == "mixed" => self.advance(),
                ExprKind::Index(word, indices) if self.sources.snippet(word.span) == "mixed" => {
                    self.advance();
                    for size in indices {
                        let n = self.number(size)?;
                        sizes.push(Some(self.size_of(n, size.span)?));
                    }
                }
                _ => {}
            }
        }
        while let Token::Entry(elements) = self.peek_on()? {
            let at = self.here();
            self.advance();
            let size = if elements.is_empty() { None } else { Some(self.array_size(elements, at)?) };
            sizes.push(size);
        }
        if sizes.len() > MAX_DIMENSIONS {
            let message = format!("an array has at most {MAX_DIMENSIONS} dimensions, this has {}", sizes.len());
            return Diagnostic::err(codes::WRONG_COUNT, span, message);
        }
        if sizes.is_empty() || sizes.contains(&None) {
            return self.array_of_braces(span);
        }
        let sizes: Box<[usize]> = sizes.into_iter().flatten().collect();
        let count = sizes.iter().try_fold(1_usize, |n, &size| n.checked_mul(size)).filter(|n| *n <= MAX_ELEMENTS);
        let Some(count) = count else {
            let message = format!("an array has at most {} million elements", MAX_ELEMENTS / 1_000_000);
            return self.limit(codes::MEMORY_LIMIT, span, message, "is a size right?");
        };
        let mut array = Array { sizes, items: vec![None; count], keys: None };
        if let Token::Group(_) = self.peek_on()? {
            let rows = array.sizes.clone();
            self.fill(&rows, &mut array.items)?;
        }
        Ok(Slot::Array(Rc::new(array)))
    }

    fn array_size(&mut self, elements: &'a [Element], at: Span) -> Result<usize> {
        let size = self.numbers_in(elements, at)?;
        match size[..] {
            [size] => self.size_of(size, at),
            _ => Diagnostic::err(codes::WRONG_COUNT, at, "each dimension of an array has one size in `[ ]`"),
        }
    }

    fn size_of(&self, size: f64, at: Span) -> Result<usize> {
        if size >= 1.0 {
            return Ok(size as usize);
        }
        Diagnostic::err(codes::BAD_INDEX, at, format!("an array can't have {size} elements"))
    }

    /// Reads `{ … }` into as many elements as the sizes say; fewer leave the rest without a value.
    fn fill(&mut self, sizes: &[usize], items: &mut [Option<Slot<'a>>]) -> Result<()> {
        let Token::Group(elements) = self.peek()? else {
            return Err(self.unexpected_token("`{` with a row of the array").into());
        };
        let span = self.here();
        self.advance();
        let rows = sizes[0];
        let stride = items.len() / rows;
        self.enclosed(None, elements, span, |me| {
            for i in 0..rows {
                if matches!(me.peek()?, Token::End) {
                    return Ok(());
                }
                if sizes.len() > 1 {
                    me.fill(&sizes[1..], &mut items[i * stride..(i + 1) * stride])?;
                } else {
                    items[i] = Some(me.array_item()?);
                }
            }
            match me.peek()? {
                Token::End => Ok(()),
                _ => Diagnostic::err(codes::WRONG_COUNT, me.here(), format!("there is room for {rows} elements only")),
            }
        })
    }

    /// An element; without sizes, braces in braces make arrays of arrays.
    fn array_item(&mut self) -> Result<Slot<'a>> {
        match self.peek()? {
            Token::Group(_) => self.array_of_braces(self.here()),
            _ => self.rvalue(),
        }
    }

    /// `array { 1, 2, 3 }` (3.8): as many elements as there are.
    pub(super) fn array_of_braces(&mut self, span: Span) -> Result<Slot<'a>> {
        let elements = match self.peek_on()? {
            Token::Group(elements) => elements,
            Token::Block(block) if block.name.word == Some("array") => &block.body,
            _ => {
                let d = Diagnostic::new(codes::WRONG_COUNT, span, "an array needs a size");
                return d.help("`array[10]`, or `array[3] { 1, 2, 3 }`").into();
            }
        };
        let at = self.here();
        self.advance();
        let items = self.enclosed(None, elements, at, |me| {
            let mut items = vec![];
            while !matches!(me.peek()?, Token::End) {
                items.push(Some(me.array_item()?));
            }
            Ok(items)
        })?;
        Ok(Slot::Array(Rc::new(Array { sizes: Box::new([items.len()]), items, keys: None })))
    }

    /// `dictionary { .Name: 1, ["other name"]: 2 }` (3.8).
    pub(super) fn dictionary(&mut self, elements: &'a [Element], at: Span) -> Result<Slot<'a>> {
        self.advance();
        let (mut keys, mut items): (Vec<Rc<str>>, Vec<Option<Slot<'a>>>) = (vec![], vec![]);
        self.enclosed(None, elements, at, |me| {
            loop {
                let key: Rc<str> = match me.peek()? {
                    Token::End => return Ok(()),
                    Token::Key(symbol) => {
                        me.advance();
                        me.names.text(symbol).into()
                    }
                    Token::Entry(inner) => {
                        let span = me.here();
                        me.advance();
                        let key = me.enclosed(None, inner, span, |me| me.text())?;
                        match me.peek()? {
                            Token::Colon => me.advance(),
                            _ => return Err(me.unexpected_token("`:` and a value").into()),
                        }
                        key.into()
                    }
                    _ => return Err(me.unexpected_token("`.Name:` or `[\"name\"]:`").into()),
                };
                let value = me.rvalue()?;
                match keys.iter().position(|k| *k == key) {
                    Some(i) => items[i] = Some(value),
                    None => {
                        keys.push(key);
                        items.push(Some(value));
                    }
                }
            }
        })?;
        Ok(Slot::Array(Rc::new(Array { sizes: Box::new([items.len()]), items, keys: Some(keys) })))
    }

    /// The place that `D.Key`, `D["key"].Key` and the like name, if D is a dictionary.
    pub(super) fn dictionary_place(&mut self, e: &'a Expr) -> Result<Option<Place>> {
        let base = match &e.kind {
            ExprKind::Name(symbol) => match self.scopes.get(*symbol) {
                Some(Slot::Array(array)) if array.keys.is_some() => return Ok(self.scopes.resolve(*symbol)),
                _ => return Ok(None),
            },
            ExprKind::Dot(base, ..) => base,
            ExprKind::Index(base, indices) => match self.dictionary_place(base)? {
                Some(_) => return self.element_place(base, indices).map(Some),
                None => return Ok(None),
            },
            _ => return Ok(None),
        };
        let Some(place) = self.dictionary_place(base)? else { return Ok(None) };
        let ExprKind::Dot(_, name, symbol) = &e.kind else { return Ok(None) };
        let Some(dictionary) = self.scopes.dictionary(&place) else { return Ok(None) };
        let key = self.names.text(*symbol);
        match dictionary.key_index(key) {
            Some(i) => Ok(Some(place.element(&[i]))),
            None => Err(self.missing_key(dictionary, key, name.span)),
        }
    }

    fn missing_key(&self, dictionary: &Array, key: &str, span: Span) -> crate::diagnostic::Fault {
        let d = Diagnostic::new(codes::UNDECLARED, span, format!("the dictionary has no `{key}`"));
        let keys = dictionary.keys.iter().flatten().map(|k| &**k);
        Box::new(d.maybe_help(did_you_mean(key, keys)))
    }

    /// What `A[i][j]` is.
    pub(super) fn indexed(&mut self, base: &'a Expr, indices: &'a [Expr], span: Span) -> Result<Slot<'a>> {
        let place = self.element_place(base, indices)?;
        self.slot_at(&place, span)
    }

    /// What [`Token::Element`] announced, which is consumed.
    pub(super) fn take_element(&mut self) -> Result<Slot<'a>> {
        let span = self.here();
        let place = self.element.take();
        self.advance();
        match place {
            Some(place) => self.slot_at(&place, span),
            None => self.no_value(span),
        }
    }

    pub(super) fn slot_at(&self, place: &Place, span: Span) -> Result<Slot<'a>> {
        match self.scopes.at(place) {
            Some(slot) => Ok(slot.clone()),
            None => self.no_value(span),
        }
    }

    fn no_value<T>(&self, span: Span) -> Result<T> {
        let text = self.sources.snippet(span);
        let d = Diagnostic::new(codes::UNDECLARED, span, format!("`{text}` has no value yet"));
        d.help(format!("`#declare {text} = …;` gives it one")).into()
    }

    /// Where `A[i][j]` is kept; that element need not have a value yet.
    pub(super) fn element_place(&mut self, base: &'a Expr, indices: &'a [Expr]) -> Result<Place> {
        match base.kind {
            ExprKind::Name(symbol) => self.place_of(symbol, base.span, indices),
            _ => Diagnostic::err(codes::WRONG_TYPE, base.span, "only a name can have an index"),
        }
    }

    /// The same for what gets a value: a dictionary's key may be new.
    pub(super) fn new_element_place(&mut self, base: &'a Expr, indices: &'a [Expr]) -> Result<Place> {
        match base.kind {
            ExprKind::Name(symbol) => self.new_place(symbol, base.span, indices),
            _ => self.element_place(base, indices),
        }
    }

    /// The same for a name and its place in the text.
    pub(super) fn new_place(&mut self, symbol: Symbol, span: Span, indices: &'a [Expr]) -> Result<Place> {
        let place = self.scopes.resolve(symbol);
        match place.filter(|place| self.scopes.dictionary(place).is_some()) {
            Some(place) => self.key_place(place, indices, true),
            None => self.place_of(symbol, span, indices),
        }
    }

    fn place_of(&mut self, symbol: Symbol, span: Span, indices: &'a [Expr]) -> Result<Place> {
        let Some(place) = self.scopes.resolve(symbol) else {
            self.name_value(symbol, span)?;
            return Diagnostic::err(codes::FOLLOWS, span, "");
        };
        if self.scopes.dictionary(&place).is_some() {
            return self.key_place(place, indices, false);
        }
        let numbers = indices.iter().map(|e| self.number(e)).collect::<Result<Vec<f64>>>()?;
        let mut path = vec![];
        let mut rest = &numbers[..];
        while !rest.is_empty() {
            let at = indices[numbers.len() - rest.len()].span;
            let slot = self.scopes.at(&place).and_then(|slot| slot.element(&path));
            if let Some(slot @ Slot::Faulty(_)) = slot {
                let slot = slot.clone();
                self.slot_value(slot, span)?;
                return Diagnostic::err(codes::FOLLOWS, span, "");
            }
            let Some(Slot::Array(array)) = slot else {
                let name = self.sources.snippet(Span { lo: span.lo, hi: at.lo.saturating_sub(1) });
                return Diagnostic::err(codes::WRONG_TYPE, at, format!("`{name}` is no array: it takes no `[…]`"));
            };
            let n = array.sizes.len();
            if rest.len() < n {
                let message = format!("this array has {n} dimensions, but {} given", counted_indices(rest.len()));
                return Diagnostic::err(codes::WRONG_COUNT, span, message);
            }
            let (mut flat, first) = (0, numbers.len() - rest.len());
            for (k, &size) in array.sizes.iter().enumerate() {
                let i = rest[k];
                if !(i > -1.0 && i < size as f64) {
                    return Err(bad_index(i, size, indices[first + k].span));
                }
                flat = flat * size + i as usize;
            }
            path.push(flat);
            rest = &rest[n..];
        }
        Ok(place.element(&path))
    }

    /// An element of a dictionary by its keys, of which the last is added if it is new and `adds` says so.
    fn key_place(&mut self, place: Place, indices: &'a [Expr], adds: bool) -> Result<Place> {
        let mut place = place;
        for (i, e) in indices.iter().enumerate() {
            let key = self.text_value(e)?;
            let Some(dictionary) = self.scopes.dictionary(&place) else {
                return Diagnostic::err(codes::WRONG_TYPE, e.span, "this is no dictionary: it has no keys");
            };
            let index = match dictionary.key_index(&key) {
                Some(index) => index,
                None if adds && i + 1 == indices.len() => self.scopes.add_key(&place, &key),
                None => return Err(self.missing_key(dictionary, &key, e.span)),
            };
            place = place.element(&[index]);
        }
        Ok(place)
    }

    /// Has the dictionary that is kept here a value under these keys?
    pub(super) fn has_keys(&mut self, mut place: Place, indices: &'a [Expr]) -> Result<bool> {
        for e in indices {
            let key = self.text_value(e)?;
            match self.scopes.dictionary(&place).and_then(|d| d.key_index(&key)) {
                Some(index) => place = place.element(&[index]),
                None => return Ok(false),
            }
        }
        Ok(self.scopes.at(&place).is_some())
    }

    /// How many elements a dimension has; the first is 1.
    pub(super) fn dimension_size(&mut self, array: &'a Expr, dimension: &'a Expr) -> Result<Value> {
        let array = self.array_argument(array)?;
        let n = self.number(dimension)?;
        match array.sizes.get((n as usize).wrapping_sub(1)).filter(|_| n >= 1.0) {
            Some(size) => Ok(Value::Float(*size as f64)),
            None => {
                let message =
                    format!("this array has {} dimensions, there is none with the number {n}", array.sizes.len());
                Diagnostic::err(codes::BAD_INDEX, dimension.span, message)
            }
        }
    }

    /// The array that an argument names, for `dimensions` and `dimension_size`.
    pub(super) fn array_argument(&mut self, e: &'a Expr) -> Result<Rc<Array<'a>>> {
        let slot = match &e.kind {
            ExprKind::Name(symbol) => self.scopes.get(*symbol).cloned(),
            ExprKind::Index(base, indices) => Some(self.indexed(base, indices, e.span)?),
            _ => None,
        };
        match slot {
            Some(Slot::Array(array)) => Ok(array),
            _ => {
                let value = self.eval(e)?;
                Diagnostic::err(codes::WRONG_TYPE, e.span, format!("expected an array, found {}", value.describe()))
            }
        }
    }
}

fn counted_indices(n: usize) -> &'static str {
    if n == 1 { "one index is" } else { "fewer indices are" }
}

fn bad_index(i: f64, size: usize, span: Span) -> crate::diagnostic::Fault {
    let message = format!("the index {i} is outside of the array, whose elements go from 0 to {}", size - 1);
    Box::new(Diagnostic::new(codes::BAD_INDEX, span, message))
}
