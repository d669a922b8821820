//! Parts that mostly have their default value: transforms, patterns, reflections. The default takes no memory, which
//! matters for scenes of a hundred thousand objects.

use crate::math::Transform;
use serde::{Serialize, Serializer};
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// A type with a static default value.
pub trait StaticDefault: Clone + 'static {
    /// Returns the static default value of the type.
    fn static_default() -> &'static Self;
}

/// A value that is mostly the default, which takes no memory. Copies share the value until one of them is changed;
/// reading, comparison and printing are those of the value.
#[derive(Debug)]
pub struct SharedDefault<T>(Option<Arc<T>>);

impl<T> SharedDefault<T> {
    /// The default value, which is shared and allocates nothing.
    pub const DEFAULT: Self = Self(None);

    /// Creates a value that is not the shared default.
    pub fn new(part: T) -> Self {
        Self(Some(Arc::new(part)))
    }

    /// True if both share one value, or both are the shared default.
    pub fn shares_with(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }

    /// Returns the value if one was set; `None` for the shared default. It may equal the default.
    pub fn explicit_value(&self) -> Option<&Arc<T>> {
        self.0.as_ref()
    }
}

impl<T: StaticDefault> SharedDefault<T> {
    /// Calls `change` with the value, and returns its result: true if the value was modified. A default that was not
    /// modified takes no memory.
    ///
    /// # Errors
    /// The error of `change`.
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
    /// Makes the value independent of its copies before a change.
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
    fn a_default_takes_no_memory_and_copies_change_independently() {
        assert_eq!(size_of::<SharedDefault<Transform>>(), size_of::<usize>());
        let mut moved = SharedDefault::<Transform>::default();
        assert_eq!(*moved, Transform::IDENTITY);
        assert!(moved.explicit_value().is_none());
        let before = moved.clone();
        *moved = moved.then(&Transform::translate(DVec3::X));
        let copy = moved.clone();
        *moved = moved.then(&Transform::translate(DVec3::X));
        assert_eq!([&before, &copy, &moved].map(|m| m.transform_point(DVec3::ZERO).x), [0.0, 1.0, 2.0]);
        assert!(before == SharedDefault::new(Transform::IDENTITY) && before != copy);
    }
}
