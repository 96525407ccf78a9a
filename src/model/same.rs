//! Equality of kinds that are known by their trait alone.

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
