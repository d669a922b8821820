//! `array[2][3] { … }`, `dictionary { … }` and their elements (manual, "Arrays").

use super::Interpreter;
use super::argument::Argument;
use super::evaluator::as_float;
use super::evaluator::{Array, Contents, LValue};
use super::stream::{StackFrame, Token};
use super::token_expr::joined_span_if_near;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::syntax::ast::{Bracket, ElementKind, Expr, ExprKind, Punctuation, Symbol};
use crate::value::{Reader, Value};
use smallvec::SmallVec;
use std::rc::Rc;

/// Maximum number of elements of an array.
const MAX_ELEMENTS: usize = 50_000_000;
/// Maximum number of dimensions, as in POV-Ray.
const MAX_DIMENSIONS: usize = 5;

/// Returns the dictionary of `#declare D = dictionary;` (3.8).
pub(super) fn empty_dictionary<'a>() -> Contents<'a> {
    Contents::Array(Rc::new(Array { sizes: Box::new([0]), items: vec![], keys: Some(vec![]) }))
}

impl<'a> Interpreter<'a> {
    /// Reads `array[2][3] { {1, 2, 3}, {4, 5, 6} }` from the word `array` on. The braces determine missing sizes (3.8).
    pub(super) fn read_array(&mut self) -> Result<Contents<'a>> {
        let span = self.stream.next_span();
        self.stream.advance();
        // 3.8 requires the word `mixed` where types are mixed. durer accepts mixed types without it.
        if let Some(ElementKind::Expr(e)) = self.stream.next_raw_element().map(|e| &e.kind) {
            if matches!(&e.kind, ExprKind::Index(word, _) if self.inputs.sources.snippet(word.span) == "mixed") {
                self.stream.split_next_element();
            }
            if self.stream.next_raw_element().is_some_and(|e| self.inputs.sources.snippet(e.span) == "mixed") {
                self.stream.advance();
            }
        }
        let mut sizes = vec![];
        while let Token::Open(Bracket::Square, _) = self.peek_continuation()? {
            sizes.push(self.read_array_size()?);
        }
        if sizes.len() > MAX_DIMENSIONS {
            let message = format!("an array has at most {MAX_DIMENSIONS} dimensions, this has {}", sizes.len());
            return Diagnostic::err(codes::WRONG_COUNT, span, message);
        }
        if sizes.is_empty() || sizes.contains(&None) {
            return self.read_braced_array(span);
        }
        let sizes: Box<[usize]> = sizes.into_iter().flatten().collect();
        let count = sizes.iter().try_fold(1_usize, |n, &size| n.checked_mul(size)).filter(|n| *n <= MAX_ELEMENTS);
        let Some(count) = count else {
            let message = format!("an array has at most {} million elements", MAX_ELEMENTS / 1_000_000);
            return self.reporter.limit_error(codes::MEMORY_LIMIT, span, message, "is a size right?");
        };
        let mut array = Array { sizes, items: vec![None; count], keys: None };
        if let Token::Open(Bracket::Brace, _) = self.peek_continuation()? {
            let rows = array.sizes.clone();
            self.read_array_rows(&rows, &mut array.items)?;
        }
        Ok(Contents::Array(Rc::new(array)))
    }

    /// Reads the array size `[3]`, or `[]` for a size that the braces determine.
    fn read_array_size(&mut self) -> Result<Option<usize>> {
        let at = self.open_bracket()?;
        let mut size = None;
        if !self.peek()?.is_closer_or_end() {
            let (value, span) = self.read_value()?;
            size = Some(self.checked_dimension_size(as_float(&value, span)?, joined_span_if_near(at, span))?);
        }
        if !self.peek()?.is_closer_or_end() {
            return Diagnostic::err(codes::WRONG_COUNT, at, "each dimension of an array has one size in `[ ]`");
        }
        self.close_bracket("`]`")?;
        Ok(size)
    }

    fn checked_dimension_size(&self, size: f64, at: Span) -> Result<usize> {
        if size >= 1.0 {
            return Ok(size as usize);
        }
        Diagnostic::err(codes::BAD_INDEX, at, format!("an array can't have {size} elements"))
    }

    /// Reads the elements `{ … }` of an array of the given sizes. Elements that are left out have no value.
    fn read_array_rows(&mut self, sizes: &[usize], items: &mut [Option<Contents<'a>>]) -> Result<()> {
        let Token::Open(Bracket::Brace, _) = self.peek()? else {
            return Err(self.unexpected_token("`{` with a row of the array").into());
        };
        self.open_bracket()?;
        let rows = sizes[0];
        let stride = items.len() / rows;
        for i in 0..rows {
            if self.peek()?.is_closer_or_end() {
                break;
            }
            if sizes.len() > 1 {
                self.read_array_rows(&sizes[1..], &mut items[i * stride..(i + 1) * stride])?;
            } else {
                items[i] = Some(self.read_array_item()?);
            }
        }
        if !self.peek()?.is_closer_or_end() {
            return Diagnostic::err(
                codes::WRONG_COUNT,
                self.stream.next_span(),
                format!("there are more than {rows} elements"),
            );
        }
        self.close_bracket("`}`")
    }

    /// Reads an element of an array. In an array without sizes, braces make an array of arrays.
    fn read_array_item(&mut self) -> Result<Contents<'a>> {
        match self.peek()? {
            Token::Open(Bracket::Brace, _) => self.read_braced_array(self.stream.next_span()),
            _ => self.read_rvalue(),
        }
    }

    /// Reads `array { 1, 2, 3 }` (3.8): the braces determine the size.
    pub(super) fn read_braced_array(&mut self, span: Span) -> Result<Contents<'a>> {
        match self.peek_continuation()? {
            Token::Open(Bracket::Brace, _) => {}
            Token::Block(block) if block.word == Some("array") => {}
            _ => {
                let d = Diagnostic::new(codes::WRONG_COUNT, span, "an array needs a size");
                return d.help("`array[10]`, or `array[3] { 1, 2, 3 }`").into();
            }
        }
        self.open_bracket()?;
        let mut items = vec![];
        while !self.peek()?.is_closer_or_end() {
            items.push(Some(self.read_array_item()?));
        }
        self.close_bracket("`}`")?;
        Ok(Contents::Array(Rc::new(Array { sizes: Box::new([items.len()]), items, keys: None })))
    }

    /// Reads `{ .Name: 1, ["other name"]: 2 }` of a `dictionary` (3.8), from the opening brace on.
    pub(super) fn read_dictionary(&mut self) -> Result<Contents<'a>> {
        self.open_bracket()?;
        let (mut keys, mut items): (Vec<Rc<str>>, Vec<Option<Contents<'a>>>) = (vec![], vec![]);
        while !self.peek()?.is_closer_or_end() {
            let key: Rc<str> = self.read_dictionary_key()?;
            match self.peek()? {
                Token::Punctuation(Punctuation::Colon) => self.stream.advance(),
                _ => return Err(self.unexpected_token("`:` and a value").into()),
            }
            let value = self.read_rvalue()?;
            match keys.iter().position(|k| *k == key) {
                Some(i) => items[i] = Some(value),
                None => {
                    keys.push(key);
                    items.push(Some(value));
                }
            }
        }
        self.close_bracket("`}`")?;
        Ok(Contents::Array(Rc::new(Array { sizes: Box::new([items.len()]), items, keys: Some(keys) })))
    }

    /// Reads a key of a dictionary: `.Name` or `["name"]`.
    fn read_dictionary_key(&mut self) -> Result<Rc<str>> {
        match self.peek()? {
            Token::Punctuation(Punctuation::Dot) => {
                self.stream.advance();
                let name = self.read_component_name()?;
                Ok(self.inputs.sources.snippet(name.span).into())
            }
            Token::Open(Bracket::Square, _) => {
                self.open_bracket()?;
                let key = self.text()?;
                self.close_bracket("`]`")?;
                Ok(key.into())
            }
            _ => Err(self.unexpected_token("`.Name:` or `[\"name\"]:`").into()),
        }
    }

    /// Reads an array's name and indices, and pushes back one token: the element, or the name if no index follows.
    pub(super) fn push_back_element_token(&mut self, symbol: Symbol, name: &'a Expr) -> Result<Token<'a>> {
        let span = name.span;
        let has_comma_before = self.stream.has_comma();
        // A comma between the name and its indices ends the value.
        let comma = self.stream.innermost().and_then(StackFrame::next).is_some_and(|e| e.comma);
        self.stream.set_comma(comma);
        self.stream.skip_element();
        if let Some(level) = self.evaluator.scope_level_of_prefix(symbol) {
            return self.push_back_prefixed_element(level, span, has_comma_before);
        }
        let indices = self.read_indices(symbol)?;
        if indices.is_empty() {
            return Ok(self.stream.push_back(Token::Expr(name), span, has_comma_before));
        }
        let whole = indices.last().map_or(span, |(_, at)| joined_span_if_near(span, Span { hi: at.hi + 1, ..*at }));
        let lvalue = self.lvalue_at(symbol, span, &indices, false)?;
        self.stream.set_array_element(lvalue);
        Ok(self.stream.push_back(Token::Element(whole), whole, has_comma_before))
    }

    /// Reads the `.A` or `.A[i]` of `local.A` or `global.A[i]` (3.8), and pushes back one [`Token::Element`] for the whole.
    /// `has_comma_before` is true if a comma precedes the prefix.
    fn push_back_prefixed_element(&mut self, level: u32, prefix: Span, has_comma_before: bool) -> Result<Token<'a>> {
        self.stream.advance();
        let Some((symbol, span)) = self.stream.take_name() else { return Err(self.unexpected_token("a name").into()) };
        let indices = self.read_indices(symbol)?;
        let named = joined_span_if_near(prefix, span);
        let (mut lvalue, mut whole) = (self.evaluator.scopes().resolve_at(symbol, level), named);
        if let Some((_, at)) = indices.last() {
            whole = joined_span_if_near(prefix, Span { hi: at.hi + 1, ..*at });
            lvalue = self.lvalue_in_array(lvalue, named, &indices, false)?;
        }
        self.stream.set_array_element(lvalue);
        Ok(self.stream.push_back(Token::Element(whole), whole, has_comma_before))
    }

    /// Reads the indices and keys that follow an array's name.
    pub(super) fn read_indices(&mut self, symbol: Symbol) -> Result<Vec<(Value, Span)>> {
        let mut indices = vec![];
        loop {
            match self.peek_directly_after_name()? {
                Some(Token::Open(Bracket::Square, _)) => {
                    self.open_bracket()?;
                    indices.push(self.read_value()?);
                    self.close_bracket("`]`")?;
                }
                Some(Token::Punctuation(Punctuation::Dot)) if self.evaluator.is_dictionary(symbol, &indices) => {
                    self.stream.advance();
                    let name = self.read_component_name()?;
                    indices.push((Value::Text(self.inputs.sources.snippet(name.span).into()), name.span));
                }
                _ => return Ok(indices),
            }
        }
    }

    /// Returns the token directly after an array's name. As in POV-Ray, no directive and no macro runs between the two,
    /// and no macro ends (quirk: `index_follows_name`).
    fn peek_directly_after_name(&mut self) -> Result<Option<Token<'a>>> {
        loop {
            if self.stream.has_comma() {
                return Ok(None);
            }
            return match self.stream.next_raw_element().map(|e| &e.kind) {
                Some(
                    ElementKind::Entry(_)
                    | ElementKind::Punctuation(Punctuation::Open(Bracket::Square) | Punctuation::Dot),
                ) => self.peek().map(Some),
                None if !self.stream.has_pushed_back()
                    && self.stream.innermost().is_some_and(StackFrame::is_spent_piece) =>
                {
                    self.pop_frame();
                    continue;
                }
                _ => Ok(None),
            };
        }
    }

    /// Returns the location of the dictionary `D`, of its element `D.Key` or `D["key"].Key`, or of `local.A` or
    /// `global.A`; `None` for any other expression. An error for a key that the dictionary lacks.
    pub(super) fn dictionary_lvalue(&mut self, e: &'a Expr) -> Result<Option<LValue>> {
        if let Some(lvalue) = self.evaluator.prefixed_lvalue(e) {
            return Ok(Some(lvalue));
        }
        let base = match &e.kind {
            ExprKind::Name(symbol) => match self.evaluator.scopes().get(*symbol) {
                Some(Contents::Array(array)) if array.keys.is_some() => {
                    return Ok(self.evaluator.scopes().resolve(*symbol));
                }
                _ => return Ok(None),
            },
            ExprKind::Dot(base, ..) => base,
            ExprKind::Index(base, indices) => match self.dictionary_lvalue(base)? {
                Some(_) => return self.element_lvalue(base, indices).map(Some),
                None => return Ok(None),
            },
            _ => return Ok(None),
        };
        let Some(lvalue) = self.dictionary_lvalue(base)? else { return Ok(None) };
        self.evaluator.dictionary_element_lvalue(&lvalue, e)
    }

    /// Returns the contents of the array element `A[i][j]`; an error if the element has no value.
    pub(super) fn evaluate_array_access(
        &mut self,
        base: &'a Expr,
        indices: &'a [Expr],
        span: Span,
    ) -> Result<Contents<'a>> {
        let lvalue = self.element_lvalue(base, indices)?;
        self.evaluator.contents_at(&lvalue, span)
    }

    /// Consumes a [`Token::Element`], and returns the contents of the element.
    pub(super) fn take_array_element(&mut self) -> Result<Contents<'a>> {
        let span = self.stream.next_span();
        let lvalue = self.stream.take_array_element();
        self.stream.advance();
        match lvalue {
            Some(lvalue) => self.evaluator.contents_at(&lvalue, span),
            None => self.evaluator.no_value_error(span),
        }
    }

    /// Returns the location of the array element `A[i][j]`, which need not have a value yet.
    pub(super) fn element_lvalue(&mut self, base: &'a Expr, indices: &'a [Expr]) -> Result<LValue> {
        if let Some(array) = self.evaluator.prefixed_lvalue(base) {
            let indices = self.index_values(indices)?;
            return self.lvalue_in_array(array, base.span, &indices, false);
        }
        match base.kind {
            ExprKind::Name(symbol) => self.lvalue_without_new_key(symbol, base.span, indices),
            _ => Diagnostic::err(codes::WRONG_TYPE, base.span, "only a name can have an index"),
        }
    }

    /// Returns the location of an element that is about to be declared. A new key is added to a dictionary.
    pub(super) fn lvalue_adding_new_key(&mut self, symbol: Symbol, span: Span, indices: &'a [Expr]) -> Result<LValue> {
        let indices = self.index_values(indices)?;
        self.lvalue_at(symbol, span, &indices, true)
    }

    fn lvalue_without_new_key(&mut self, symbol: Symbol, span: Span, indices: &'a [Expr]) -> Result<LValue> {
        let indices = self.index_values(indices)?;
        self.lvalue_at(symbol, span, &indices, false)
    }

    fn index_values(&mut self, indices: &'a [Expr]) -> Result<SmallVec<[(Value, Span); 2]>> {
        indices.iter().map(|e| Ok((self.evaluate(e)?, e.span))).collect()
    }

    /// Returns the location of the element at these indices or keys. `adds_key` adds a new last key to a dictionary.
    pub(super) fn lvalue_at(
        &mut self,
        symbol: Symbol,
        span: Span,
        indices: &[(Value, Span)],
        adds_key: bool,
    ) -> Result<LValue> {
        let Some(lvalue) = self.evaluator.scopes().resolve(symbol) else {
            self.evaluate_name(symbol, span)?;
            return Diagnostic::err(codes::FOLLOWS, span, "");
        };
        self.lvalue_in_array(lvalue, span, indices, adds_key)
    }

    /// Returns the location of the element at these indices or keys of the array at `lvalue`, whose name is at `span`.
    /// `adds_key` adds a new last key to a dictionary.
    pub(super) fn lvalue_in_array(
        &mut self,
        lvalue: LValue,
        span: Span,
        indices: &[(Value, Span)],
        adds_key: bool,
    ) -> Result<LValue> {
        if self.evaluator.scopes().dictionary(&lvalue).is_some() {
            return self.evaluator.key_lvalue(lvalue, indices, adds_key);
        }
        let numbers: SmallVec<[f64; 4]> =
            indices.iter().map(|(value, at)| as_float(value, *at)).collect::<Result<_>>()?;
        let mut path = SmallVec::<[usize; 4]>::new();
        let mut rest = &numbers[..];
        while !rest.is_empty() {
            let at = indices[numbers.len() - rest.len()].1;
            let contents = self.evaluator.scopes().contents_at(&lvalue).and_then(|contents| contents.element(&path));
            if let Some(contents @ Contents::Faulty(_)) = contents {
                let contents = contents.clone();
                self.value_of_contents(contents, span)?;
                return Diagnostic::err(codes::FOLLOWS, span, "");
            }
            let Some(Contents::Array(array)) = contents else {
                let name = self.inputs.sources.snippet(Span { lo: span.lo, hi: at.lo.saturating_sub(1) });
                return Diagnostic::err(codes::WRONG_TYPE, at, format!("`{name}` is no array: it takes no `[…]`"));
            };
            let n = array.sizes.len();
            if rest.len() < n {
                let message =
                    format!("this array has {n} dimensions, but {} given", needed_indices_with_verb(rest.len()));
                return Diagnostic::err(codes::WRONG_COUNT, span, message);
            }
            let (mut flat, first) = (0, numbers.len() - rest.len());
            for (k, &size) in array.sizes.iter().enumerate() {
                let i = rest[k];
                if !(i > -1.0 && i < size as f64) {
                    return Err(bad_index_error(i, size, indices[first + k].1));
                }
                flat = flat * size + i as usize;
            }
            path.push(flat);
            rest = &rest[n..];
        }
        Ok(lvalue.element(&path))
    }

    /// True if the dictionary at a location has a value at these keys.
    pub(super) fn has_keys(&mut self, mut lvalue: LValue, indices: &'a [Expr]) -> Result<bool> {
        for e in indices {
            let key = self.evaluate_text(e)?;
            match self.evaluator.scopes().dictionary(&lvalue).and_then(|d| d.key_index(&key)) {
                Some(index) => lvalue = lvalue.element(&[index]),
                None => return Ok(false),
            }
        }
        Ok(self.evaluator.scopes().contents_at(&lvalue).is_some())
    }

    /// Returns the number of elements of an array's dimension; the first dimension is 1.
    pub(super) fn dimension_size(&mut self, array: &Argument<'a>, dimension: &Argument<'a>) -> Result<Value> {
        let array = self.array_argument(array)?;
        let n = self.argument_number(dimension)?;
        match array.sizes.get((n as usize).wrapping_sub(1)).filter(|_| n >= 1.0) {
            Some(size) => Ok(Value::Float(*size as f64)),
            None => {
                let message =
                    format!("this array has {} dimensions, but dimension {n} was asked for", array.sizes.len());
                Diagnostic::err(codes::BAD_INDEX, dimension.span, message)
            }
        }
    }

    /// Returns the array that an argument names, for `dimensions` and `dimension_size`.
    pub(super) fn array_argument(&mut self, argument: &Argument<'a>) -> Result<Rc<Array<'a>>> {
        match self.argument_contents(argument)? {
            Contents::Array(array) => Ok(array),
            contents => {
                let value = self.value_of_contents(contents, argument.span)?;
                let message = format!("expected an array, found {}", value.describe());
                Diagnostic::err(codes::WRONG_TYPE, argument.span, message)
            }
        }
    }
}

fn needed_indices_with_verb(n: usize) -> &'static str {
    if n == 1 { "one index is" } else { "fewer indices are" }
}

fn bad_index_error(i: f64, size: usize, span: Span) -> crate::diagnostic::Fault {
    let message = format!("the index {i} is outside of the array, whose elements go from 0 to {}", size - 1);
    Box::new(Diagnostic::new(codes::BAD_INDEX, span, message))
}
