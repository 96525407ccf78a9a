//! WGSL as kinds name it, and what it costs.

use std::borrow::Cow;

/// A piece of WGSL.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Wgsl {
    /// A part of `shaders/`, by its path without the extension.
    Part(Cow<'static, str>),
    /// Text of a user's own, or written for a scene.
    Text {
        /// What errors call it: a path, or a name below `generated/`.
        file: Cow<'static, str>,
        /// The WGSL.
        text: Cow<'static, str>,
    },
}

impl Wgsl {
    /// Parts of `shaders/`.
    #[must_use]
    pub fn parts(names: &[&'static str]) -> Vec<Self> {
        names.iter().map(|name| Self::Part((*name).into())).collect()
    }
}

impl From<&'static str> for Wgsl {
    fn from(part: &'static str) -> Self {
        Self::Part(part.into())
    }
}

/// Iterations of the loops in a law or an index, at most: software devices stop an invocation that takes too many.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Loops {
    /// Of one evaluation of the derivative.
    pub derivative: u64,
    /// Of one evaluation of the scale.
    pub scale: u64,
}

impl Loops {
    /// The larger of each.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self { derivative: self.derivative.max(other.derivative), scale: self.scale.max(other.scale) }
    }
}
