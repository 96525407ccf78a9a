//! WGSL as kinds name it, and what it costs.

use std::borrow::Cow;
use std::sync::Arc;

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
    /// A file of the user's own.
    Own(OwnWgsl),
}

/// WGSL of the user's own: checked against what it has to promise, and kept from everything else.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OwnWgsl {
    /// What errors call it.
    pub file: String,
    /// The WGSL.
    pub text: Arc<str>,
    /// The functions that others call.
    pub promises: Vec<Promise>,
}

/// A function that a file of the user's own has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Promise {
    /// Its signature, as `fn name(x: Real3) -> Real`.
    pub signature: &'static str,
    /// The part that has it where the file has not; none if the file must.
    pub usual: Option<&'static str>,
}

impl Promise {
    /// A function that must be there.
    #[must_use]
    pub const fn required(signature: &'static str) -> Self {
        Self { signature, usual: None }
    }

    /// A function that may be there, and the part that has it otherwise.
    #[must_use]
    pub const fn usual(signature: &'static str, part: &'static str) -> Self {
        Self { signature, usual: Some(part) }
    }

    /// The function's name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        let name = self.signature.strip_prefix("fn ").unwrap_or(self.signature);
        name.split('(').next().unwrap_or(name)
    }
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
