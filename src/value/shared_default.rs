//! Parts that most things leave as they are: a transform, a pattern, a mirror. A scene of a hundred thousand objects has no
//! room for what none of them says.

use crate::math::Transform;
use serde::{Serialize, Serializer};
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// What a part is like if nobody says anything of it.
pub trait StaticDefault: Clone + 'static {
    /// Equal to the default.
    fn static_default() -> &'static Self;
}

/// A part that seldom is anything but the usual one, which takes no room. Copies share it until one of them is changed.
/// It is read, changed, compared and printed as the part itself.
#[derive(Debug)]
pub struct SharedDefault<T>(Option<Arc<T>>);

impl<T> SharedDefault<T> {
    /// The usual one.
    pub const DEFAULT: Self = Self(None);

    /// One of its own.
    pub fn new(part: T) -> Self {
        Self(Some(Arc::new(part)))
    }

    /// Do both share one part, or are both the usual one?
    pub fn shares_with(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }

    /// The part, if it is another than the usual one. (It may have been changed to what equals it.)
    pub fn explicit(&self) -> Option<&Arc<T>> {
        self.0.as_ref()
    }
}

impl<T: StaticDefault> SharedDefault<T> {
    /// Lets `change` change it, which says whether it did: what stays the usual one takes no room.
    ///
    /// # Errors
    /// That of `change`.
    pub fn modify_if<E>(&mut self, change: impl FnOnce(&mut T) -> Result<bool, E>) -> Result<bool, E> {
        if self.0.is_some() {
            return change(self);
        }
        let mut part = T::static_default().clone();
        let changed = change(&mut part)?;
        if changed {
            *self = Self::new(part);
        }
        Ok(changed)
    }
}

impl<T> Clone for SharedDefault<T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<T> Default for SharedDefault<T> {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl<T> From<T> for SharedDefault<T> {
    fn from(part: T) -> Self {
        Self::new(part)
    }
}

impl<T: StaticDefault> Deref for SharedDefault<T> {
    type Target = T;

    fn deref(&self) -> &T {
        match &self.0 {
            Some(part) => part,
            None => T::static_default(),
        }
    }
}

impl<T: StaticDefault> DerefMut for SharedDefault<T> {
    /// Its own from now on.
    fn deref_mut(&mut self) -> &mut T {
        Arc::make_mut(self.0.get_or_insert_with(|| Arc::new(T::static_default().clone())))
    }
}

impl<T: StaticDefault + PartialEq> PartialEq for SharedDefault<T> {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (None, None) => true,
            (Some(a), Some(b)) if Arc::ptr_eq(a, b) => true,
            _ => **self == **other,
        }
    }
}

impl<T: StaticDefault + Serialize> Serialize for SharedDefault<T> {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        (**self).serialize(s)
    }
}

impl StaticDefault for Transform {
    fn static_default() -> &'static Self {
        &Self::IDENTITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn the_usual_part_takes_no_room_and_copies_are_apart() {
        assert_eq!(size_of::<SharedDefault<Transform>>(), size_of::<usize>());
        let mut moved = SharedDefault::<Transform>::default();
        assert_eq!(*moved, Transform::IDENTITY);
        assert!(moved.explicit().is_none());
        let before = moved.clone();
        *moved = moved.then(&Transform::translate(DVec3::X));
        let copy = moved.clone();
        *moved = moved.then(&Transform::translate(DVec3::X));
        assert_eq!([&before, &copy, &moved].map(|m| m.point(DVec3::ZERO).x), [0.0, 1.0, 2.0]);
        assert!(before == SharedDefault::new(Transform::IDENTITY) && before != copy);
    }
}
