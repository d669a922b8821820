//! Deduplication of equal parts of objects: a loop may read the same finish a hundred thousand times.

use crate::shape::{Kernel, Shape};
use crate::texture::{Finish, Normal, Texture};
use smallvec::SmallVec;
use std::cell::RefCell;
use std::sync::Arc;

/// Number of recent parts that are compared, for each type. Macros rarely alternate between more parts.
const MAX_RECENT: usize = 4;

/// The parts of objects that were read last.
#[derive(Debug, Default)]
pub struct RecentParts {
    finishes: Recent<Finish>,
    normals: Recent<Normal>,
    textures: Recent<Texture>,
    /// Recent shapes that build caches while tracing.
    shapes: RefCell<SmallVec<[Shape; MAX_RECENT]>>,
}

/// List of the most recently read parts of objects, for one type of part.
type Recent<T> = RefCell<SmallVec<[Arc<T>; MAX_RECENT]>>;

impl RecentParts {
    /// Replaces a texture, its finishes and its normals by equal ones that were read recently.
    pub fn deduplicate(&self, texture: &mut Arc<Texture>) {
        // A texture that is shared already stays as it is.
        let Some(own) = Arc::get_mut(texture) else { return };
        for layer in &mut own.layers {
            replace_by_recent(&self.finishes, &mut layer.finish, Finish::eq);
            if let Some(normal) = &mut layer.normal {
                replace_by_recent(&self.normals, normal, Normal::is_certainly_equal);
            }
        }
        replace_by_recent(&self.textures, texture, Texture::is_certainly_equal);
    }

    /// Returns a recent shape that equals this one, if the shape builds caches while tracing.
    pub fn find_shape(&self, shape: &Shape) -> Option<Shape> {
        if !shape.caches_lazily() {
            return None;
        }
        self.shapes.borrow().iter().find(|other| *other == shape).cloned()
    }

    /// Adds a shape to the recent ones if it builds caches while tracing; ignores any other shape.
    pub fn add_shape(&self, shape: &Shape) {
        if shape.caches_lazily() {
            push(&mut self.shapes.borrow_mut(), shape.clone());
        }
    }
}

/// Adds a part, and drops the oldest one if the list is full.
fn push<T>(recent: &mut SmallVec<[T; MAX_RECENT]>, thing: T) {
    if recent.len() == MAX_RECENT {
        recent.remove(0);
    }
    recent.push(thing);
}

fn replace_by_recent<T>(recent: &Recent<T>, thing: &mut Arc<T>, alike: impl Fn(&T, &T) -> bool) {
    let mut recent = recent.borrow_mut();
    match recent.iter().find(|other| Arc::ptr_eq(other, thing) || alike(other, thing)) {
        Some(other) => *thing = other.clone(),
        None => push(&mut recent, thing.clone()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Color, Rgb};
    use crate::texture::{Layer, Pigment};

    fn texture(color: f64, diffuse: f64) -> Arc<Texture> {
        let pigment = Pigment::solid(Color { rgb: Rgb::splat(color), ..Color::BLACK });
        let finish = Arc::new(Finish { diffuse, ..Finish::default() });
        Arc::new(Texture { layers: vec![Layer { pigment, finish, ..Layer::default() }] })
    }

    #[test]
    fn equal_parts_are_shared() {
        let recent = RecentParts::default();
        let mut all = [(0.0, 0.5), (1.0, 0.5), (1.0, 0.5), (1.0, 0.7)].map(|(color, diffuse)| texture(color, diffuse));
        let before = all.clone().map(|t| (*t).clone());
        all.iter_mut().for_each(|t| recent.deduplicate(t));
        assert_eq!(all.clone().map(|t| (*t).clone()), before);
        let one = |i: usize, j: usize| {
            let finish = |i: usize| &all[i].layers[0].finish;
            (Arc::ptr_eq(&all[i], &all[j]), Arc::ptr_eq(finish(i), finish(j)))
        };
        assert_eq!([one(0, 1), one(1, 2), one(2, 3)], [(false, true), (true, true), (false, false)]);
    }
}
