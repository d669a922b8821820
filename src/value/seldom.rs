//! Parts that most things leave as they are: a transform, a pattern, a mirror. A scene of a hundred thousand objects has no
//! room for what none of them says.

use crate::math::Transform;
use serde::{Serialize, Serializer};
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// What a part is like if nobody says anything of it.
pub trait Usual: Clone + 'static {
    /// Equal to the default.
    fn usual() -> &'static Self;
}

/// A part that seldom is anything but the usual one, which takes no room. Copies share it until one of them is changed.
/// It is read, changed, compared and printed as the part itself.
#[derive(Debug)]
pub struct Seldom<T>(Option<Arc<T>>);

impl<T> Seldom<T> {
    /// The usual one.
    pub const USUAL: Self = Self(None);

    /// One of its own.
    pub fn new(part: T) -> Self {
        Self(Some(Arc::new(part)))
    }

    /// Do both share one part, or are both the usual one?
    pub fn is_one_with(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }

    /// The part, if it is another than the usual one. (It may have been changed to what equals it.)
    pub fn unusual(&self) -> Option<&Arc<T>> {
        self.0.as_ref()
    }
}

impl<T: Usual> Seldom<T> {
    /// Lets `change` change it, which says whether it did: what stays the usual one takes no room.
    ///
    /// # Errors
    /// That of `change`.
    pub fn change_if<E>(&mut self, change: impl FnOnce(&mut T) -> Result<bool, E>) -> Result<bool, E> {
        if self.0.is_some() {
            return change(self);
        }
        let mut part = T::usual().clone();
        let changed = change(&mut part)?;
        if changed {
            *self = Self::new(part);
        }
        Ok(changed)
    }
}

impl<T> Clone for Seldom<T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<T> Default for Seldom<T> {
    fn default() -> Self {
        Self::USUAL
    }
}

impl<T> From<T> for Seldom<T> {
    fn from(part: T) -> Self {
        Self::new(part)
    }
}

impl<T: Usual> Deref for Seldom<T> {
    type Target = T;

    fn deref(&self) -> &T {
        match &self.0 {
            Some(part) => part,
            None => T::usual(),
        }
    }
}

impl<T: Usual> DerefMut for Seldom<T> {
    /// Its own from now on.
    fn deref_mut(&mut self) -> &mut T {
        Arc::make_mut(self.0.get_or_insert_with(|| Arc::new(T::usual().clone())))
    }
}

impl<T: Usual + PartialEq> PartialEq for Seldom<T> {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (None, None) => true,
            (Some(a), Some(b)) if Arc::ptr_eq(a, b) => true,
            _ => **self == **other,
        }
    }
}

impl<T: Usual + Serialize> Serialize for Seldom<T> {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        (**self).serialize(s)
    }
}

impl Usual for Transform {
    fn usual() -> &'static Self {
        &Self::IDENTITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn the_usual_part_takes_no_room_and_copies_are_apart() {
        assert_eq!(size_of::<Seldom<Transform>>(), size_of::<usize>());
        let mut moved = Seldom::<Transform>::default();
        assert_eq!(*moved, Transform::IDENTITY);
        assert!(moved.unusual().is_none());
        let before = moved.clone();
        *moved = moved.then(&Transform::translate(DVec3::X));
        let copy = moved.clone();
        *moved = moved.then(&Transform::translate(DVec3::X));
        assert_eq!([&before, &copy, &moved].map(|m| m.point(DVec3::ZERO).x), [0.0, 1.0, 2.0]);
        assert!(before == Seldom::new(Transform::IDENTITY) && before != copy);
    }
}
