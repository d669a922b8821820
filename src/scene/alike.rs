//! Things that are alike are one: a loop reads the same finish a hundred thousand times.

use crate::shape::{Kernel, Shape};
use crate::texture::{Finish, Normal, Texture};
use smallvec::SmallVec;
use std::cell::RefCell;
use std::sync::Arc;

/// As many are remembered of each kind: macros take turns, but seldom more than a few of them.
const ROOM: usize = 4;

/// What was read last.
#[derive(Debug, Default)]
pub struct Alike {
    finishes: Recent<Finish>,
    normals: Recent<Normal>,
    textures: Recent<Texture>,
    /// Those that learn.
    shapes: RefCell<SmallVec<[Shape; ROOM]>>,
}

/// The last few of one kind.
type Recent<T> = RefCell<SmallVec<[Arc<T>; ROOM]>>;

impl Alike {
    /// Makes a texture one with those that it is like, and its finishes and normals too.
    pub fn join(&self, texture: &mut Arc<Texture>) {
        // Nobody else may have it: what is shared already stays so.
        let Some(own) = Arc::get_mut(texture) else { return };
        for layer in &mut own.layers {
            join(&self.finishes, &mut layer.finish, Finish::eq);
            if let Some(normal) = &mut layer.normal {
                join(&self.normals, normal, Normal::is_plainly);
            }
        }
        join(&self.textures, texture, Texture::is_plainly);
    }

    /// The shape that was read before and is like this one.
    pub fn of_shape(&self, shape: &Shape) -> Option<Shape> {
        if !shape.caches_lazily() {
            return None;
        }
        self.shapes.borrow().iter().find(|other| *other == shape).cloned()
    }

    /// Remembers a shape that learns.
    pub fn remember(&self, shape: &Shape) {
        if shape.caches_lazily() {
            push(&mut self.shapes.borrow_mut(), shape.clone());
        }
    }
}

/// The last few: the oldest of them is forgotten.
fn push<T>(recent: &mut SmallVec<[T; ROOM]>, thing: T) {
    if recent.len() == ROOM {
        recent.remove(0);
    }
    recent.push(thing);
}

fn join<T>(recent: &Recent<T>, thing: &mut Arc<T>, alike: impl Fn(&T, &T) -> bool) {
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
    fn what_is_alike_is_one() {
        let alike = Alike::default();
        let mut all = [(0.0, 0.5), (1.0, 0.5), (1.0, 0.5), (1.0, 0.7)].map(|(color, diffuse)| texture(color, diffuse));
        let told = all.clone().map(|t| (*t).clone());
        all.iter_mut().for_each(|t| alike.join(t));
        assert_eq!(all.clone().map(|t| (*t).clone()), told);
        let one = |i: usize, j: usize| {
            let finish = |i: usize| &all[i].layers[0].finish;
            (Arc::ptr_eq(&all[i], &all[j]), Arc::ptr_eq(finish(i), finish(j)))
        };
        assert_eq!([one(0, 1), one(1, 2), one(2, 3)], [(false, true), (true, true), (false, false)]);
    }
}
