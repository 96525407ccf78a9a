//! Equality of kinds: of those that are known by their trait alone, and of those that are rows of a table.

use std::any::Any;

/// What can be compared with any other kind, and asked which it is. Every kind that is [`PartialEq`] is that.
pub trait Same: Any {
    /// Is the other of the same kind, and equal?
    fn is_same(&self, other: &dyn Any) -> bool;

    /// Itself, to be asked for its kind.
    fn as_any(&self) -> &dyn Any;
}

impl<T: PartialEq + Any> Same for T {
    fn is_same(&self, other: &dyn Any) -> bool {
        other.downcast_ref::<T>() == Some(self)
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// Equality of a trait's objects, and the question which kind one is.
macro_rules! same {
    ($kind:ident) => {
        impl PartialEq for dyn $kind {
            fn eq(&self, other: &Self) -> bool {
                self.is_same(other.as_any())
            }
        }

        impl dyn $kind {
            /// As this kind, if it is that.
            #[must_use]
            pub fn downcast<T: 'static>(&self) -> Option<&T> {
                self.as_any().downcast_ref()
            }
        }
    };
}
pub(super) use same;

/// Rows of a table are equal, and printed, by their `name`.
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
