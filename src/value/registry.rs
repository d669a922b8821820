//! Registry of a family of blocks, such as all shapes: from one list of types, the macro `family!` makes the closed enum
//! of the family's members, which is read by name. `delegate!` implements a trait for the enum by its members' methods.
//!
//! The enum dispatches by `match`, without virtual calls. The crates for this, `enum_dispatch` and `ambassador`, would
//! replace `delegate!` alone, by a procedural macro, and cannot pass through the `Arc` around a member.

use super::{Next, Reader, Spec};
use crate::diagnostic::Result;
use crate::source::Span;
use std::sync::Arc;

/// A closed set of blocks of one kind, whose members are [`Readable`](super::Readable).
pub trait Family: Sized {
    /// Descriptions of all members of this family, such as those of all shapes or of all warps.
    const SPECS: &'static [&'static Spec];

    /// Description of this member's block.
    fn spec(&self) -> &'static Spec;

    /// Reads the positional parameters of the member that `next` names; `None` if it names no member. The name has been
    /// consumed, with the opening brace of a `Next::Block`.
    fn read_params(next: Next, r: &mut dyn Reader) -> Option<Result<Self>>;

    /// Reads one of the member's own words and its value, if it is next; returns false otherwise.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool>;

    /// Completes the member after the last item of its block, and checks it; `span` is the block's name. Warnings are
    /// reported to `r`.
    ///
    /// # Errors
    /// A diagnostic for a block that is complete but invalid.
    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()>;

    /// Returns the description of the family's member with this name; `None` if no member has the name.
    fn spec_of(name: &str) -> Option<&'static Spec> {
        Self::SPECS.iter().find(|spec| spec.name == name).copied()
    }

    /// True if a member of the family has this name.
    fn is_name(name: &str) -> bool {
        Self::spec_of(name).is_some()
    }

    /// Reads the name and the positional parameters of the member that `next` names; `None` if it names no member.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_named(next: Next, r: &mut dyn Reader) -> Result<Option<Self>> {
        match next {
            Next::Word(name) | Next::Block(name) if Self::is_name(name) => {
                r.take_token()?;
                Self::read_params(next, r).transpose()
            }
            _ => Ok(None),
        }
    }
}

/// Storage of a member of type `T` in its family's enum: `T` itself, or an [`Arc`] that clones of the enum share.
pub trait Stored<T> {
    /// Returns the member for modification; a shared member is cloned first.
    fn member_mut(&mut self) -> &mut T;
}

impl<T> Stored<T> for T {
    fn member_mut(&mut self) -> &mut T {
        self
    }
}

impl<T: Clone> Stored<T> for Arc<T> {
    fn member_mut(&mut self) -> &mut T {
        Arc::make_mut(self)
    }
}

/// Defines the enum of a family from the types of its members, with [`Family`] and `From` for it. A macro with the
/// enum's name evaluates an expression for a member of any type: `Shape!(self, member => member.bounds())`, and for a
/// member that is changed `Shape!(mut self, member => member.complete_and_check(span, r))`.
macro_rules! family {
    ($(#[$doc:meta])* pub enum $enum:ident { $($name:ident)* }) => {
        family! { @ $(#[$doc])* $enum { $($name($name in $name))* } }
    };
    ($(#[$doc:meta])* pub enum $enum:ident { $($name:ident($type:ident))* }) => {
        family! { @ $(#[$doc])* $enum { $($name($type in $type))* } }
    };
    ($(#[$doc:meta])* pub enum $enum:ident in Arc { $($name:ident)* }) => {
        family! { @ $(#[$doc])* $enum { $($name($name in std::sync::Arc<$name>))* } }
    };
    (@ $(#[$doc:meta])* $enum:ident { $($name:ident($type:ident in $stored:ty))* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, serde::Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $enum { $(#[doc = concat!("See [`", stringify!($type), "`].")] $name($stored)),* }

        macro_rules! $enum {
            (mut $value:expr, $member:ident => $result:expr) => {
                match $value {
                    $($enum::$name(stored) => {
                        let $member = <$stored as $crate::value::Stored<$type>>::member_mut(stored);
                        $result
                    })*
                }
            };
            ($value:expr, $member:ident => $result:expr) => { match $value { $($enum::$name($member) => $result),* } };
        }

        impl $crate::value::Family for $enum {
            const SPECS: &'static [&'static $crate::value::Spec] = &[$(&<$type as $crate::value::Readable>::SPEC),*];

            fn spec(&self) -> &'static $crate::value::Spec {
                match self { $($enum::$name(_) => &<$type as $crate::value::Readable>::SPEC),* }
            }

            fn read_params(
                next: $crate::value::Next,
                r: &mut dyn $crate::value::Reader,
            ) -> Option<$crate::diagnostic::Result<Self>> {
                $(if let Some(member) = <$type as $crate::value::Readable>::read_params(next, r) {
                    return Some(member.map(Self::from));
                })*
                None
            }

            fn read_own(
                &mut self,
                next: $crate::value::Next,
                r: &mut dyn $crate::value::Reader,
            ) -> $crate::diagnostic::Result<bool> {
                $enum!(mut self, member => $crate::value::Readable::read_own(member, next, r))
            }

            fn complete_and_check(
                &mut self,
                span: $crate::source::Span,
                r: &mut dyn $crate::value::Reader,
            ) -> $crate::diagnostic::Result<()> {
                $enum!(mut self, member => $crate::value::Readable::complete_and_check(member, span, r))
            }
        }

        $(impl From<$type> for $enum {
            fn from(member: $type) -> Self {
                $enum::$name(member.into())
            }
        })*
    };
}
pub(crate) use family;

/// Implements a trait for the enum of a family by the methods of its members.
macro_rules! delegate {
    (impl $trait:ident for $enum:ident { $($(#[$attribute:meta])* fn $method:ident $params:tt $(-> $result:ty)?;)* }) => {
        // A method that is not in the list would have the trait's default for all members.
        #[warn(clippy::missing_trait_methods)]
        impl $trait for $enum { $(delegate! { @ $enum $(#[$attribute])* fn $method $params $(-> $result)? })* }
    };
    (@ $enum:ident $(#[$attribute:meta])* fn $method:ident(&self $(, $arg:ident: $type:ty)*) $(-> $result:ty)?) => {
        $(#[$attribute])*
        fn $method(&self $(, $arg: $type)*) $(-> $result)? { $enum!(self, member => member.$method($($arg),*)) }
    };
    (@ $enum:ident $(#[$attribute:meta])* fn $method:ident(&mut self $(, $arg:ident: $type:ty)*) $(-> $result:ty)?) => {
        $(#[$attribute])*
        fn $method(&mut self $(, $arg: $type)*) $(-> $result)? {
            $enum!(mut self, member => member.$method($($arg),*))
        }
    };
}
pub(crate) use delegate;
