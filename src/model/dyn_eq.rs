//! Equality of kinds, both for trait objects and for rows of a table.

use std::any::Any;

/// A value that can be compared with any other kind and downcast. Every [`PartialEq`] kind implements it.
pub trait DynEq: Any {
    /// Returns `true` if the other value has the same type and is equal.
    fn is_same(&self, other: &dyn Any) -> bool;

    /// Returns the value for a downcast.
    fn as_any(&self) -> &dyn Any;
}

impl<T: PartialEq + Any> DynEq for T {
    fn is_same(&self, other: &dyn Any) -> bool {
        other.downcast_ref::<T>() == Some(self)
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// Implements equality and downcasts for trait objects.
macro_rules! same {
    ($kind:ident) => {
        impl PartialEq for dyn $kind {
            fn eq(&self, other: &Self) -> bool {
                self.is_same(other.as_any())
            }
        }

        impl dyn $kind {
            /// Returns the value as this kind, if it is one.
            #[must_use]
            pub fn downcast<T: 'static>(&self) -> Option<&T> {
                self.as_any().downcast_ref()
            }
        }
    };
}
pub(super) use same;

/// Implements equality and `Debug` of table rows by their `name`.
macro_rules! named {
    ($row:ident) => {
        impl PartialEq for $row {
            fn eq(&self, other: &Self) -> bool {
                self.name == other.name
            }
        }

        impl std::fmt::Debug for $row {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.name)
            }
        }
    };
}
pub(super) use named;
