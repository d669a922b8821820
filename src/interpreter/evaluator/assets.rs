//! Files and objects that are loaded once per run.

use crate::font::{self, Font};
use crate::image_io::Picture;
use crate::value::Thing;
use crate::world::Probe;
use rustc_hash::FxHashMap;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;

/// Maximum number of objects that are kept ready for ray queries.
const MAX_PROBES: usize = 256;

/// Files and objects that are loaded once per run.
#[derive(Default)]
pub struct Assets {
    /// Decoded picture files that the scene uses, by path.
    pub pictures: FxHashMap<PathBuf, Arc<Picture>>,
    /// Shapes built from mesh files that the scene uses, by path.
    pub meshes: FxHashMap<PathBuf, Arc<dyn Thing>>,
    /// Parsed fonts that the scene uses, by location.
    pub fonts: FxHashMap<font::FontLocation, Arc<Font>>,
    /// Font files by the name of the family; `None` for a family that is not installed.
    pub families: FxHashMap<String, Option<font::FontLocation>>,
    /// Objects that `trace` or `inside` has queried, by address. They are kept alive, so that addresses stay unique.
    probes: FxHashMap<*const (), (Arc<dyn Thing>, Rc<Probe>)>,
}

impl Assets {
    /// Returns the probe (an object prepared for ray queries) of the object at this address; `None` if no probe is
    /// cached.
    pub fn probe(&self, object: *const ()) -> Option<Rc<Probe>> {
        self.probes.get(&object).map(|(_, probe)| probe.clone())
    }

    pub fn add_probe(&mut self, object: Arc<dyn Thing>, probe: Rc<Probe>) {
        if self.probes.len() >= MAX_PROBES {
            self.probes.clear();
        }
        self.probes.insert(Arc::as_ptr(&object).cast::<()>(), (object, probe));
    }
}
