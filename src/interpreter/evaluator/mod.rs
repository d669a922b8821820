//! Values, scopes, constants, random streams and cached assets of a run.

mod operators;
mod quick;
mod scope;
mod timing;

use crate::font::{self, Font};
use crate::image_io::Picture;
use crate::syntax::ast::Symbol;
use crate::value::{Thing, Value};
use crate::world::Probe;
pub(super) use operators::{
    SMALL, apply, apply_prefix, component, component_index, holds_zero, numbers_of, on_floats, on_vectors,
};
pub(super) use quick::Quick;
use rustc_hash::FxHashMap;
pub(super) use scope::{Array, Place, Scopes, Slot};
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;
pub use timing::Timing;

/// Values, scopes, constants, random streams and cached assets of a run.
#[derive(Default)]
pub(super) struct Evaluator<'a> {
    /// An empty list for the arguments of the next call.
    pub(super) call_slots: Vec<Option<Slot<'a>>>,
    pub(super) scopes: Scopes<'a>,
    pub(super) deprecated: FxHashMap<Symbol, &'a str>,
    /// What constants stand for that never change, by symbol.
    pub(super) constants: Vec<Option<Value>>,
    /// States of the streams that `seed()` opened.
    pub(super) random: Vec<u32>,
    /// Declared objects that were asked by rays, by their addresses.
    pub(super) probes: FxHashMap<*const (), (Arc<dyn Thing>, Rc<Probe>)>,
    /// Decoded picture files.
    pub(super) pictures: FxHashMap<PathBuf, Arc<Picture>>,
    /// What files of meshes became.
    pub(super) meshes: FxHashMap<PathBuf, Arc<dyn Thing>>,
    /// Fonts that were read.
    pub(super) fonts: FxHashMap<font::Place, Arc<Font>>,
    /// What was found of families of fonts.
    pub(super) families: FxHashMap<String, Option<font::Place>>,
}
