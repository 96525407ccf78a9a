//! References to WGSL code.

use std::borrow::Cow;
use std::sync::Arc;

/// A piece of WGSL code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Wgsl {
    /// A module of `shaders/`, by its path without the extension.
    Part(Cow<'static, str>),
    /// Custom text, or text generated for a scene.
    Text {
        /// The name in error messages: a path, or a name below `generated/`.
        file: Cow<'static, str>,
        /// The WGSL code.
        text: Cow<'static, str>,
    },
    /// A custom file.
    Own(UserWgsl),
}

/// Custom WGSL code, which is checked for its required functions and cannot use other names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UserWgsl {
    /// The name in error messages.
    pub file: String,
    /// The WGSL code.
    pub text: Arc<str>,
    /// The functions that other modules call.
    pub promises: Vec<Promise>,
}

/// A function that a custom file may or must define.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Promise {
    /// The signature, such as `fn name(x: Real3) -> Real`.
    pub signature: &'static str,
    /// The module that defines the function if the file does not; `None` if the file must define it.
    pub usual: Option<&'static str>,
}

impl Promise {
    /// Creates a function that must be defined.
    #[must_use]
    pub const fn required(signature: &'static str) -> Self {
        Self { signature, usual: None }
    }

    /// Creates a function that may be defined, with the module that otherwise defines it.
    #[must_use]
    pub const fn usual(signature: &'static str, part: &'static str) -> Self {
        Self { signature, usual: Some(part) }
    }

    /// Returns the name of the function.
    #[must_use]
    pub fn name(&self) -> &'static str {
        let name = self.signature.strip_prefix("fn ").unwrap_or(self.signature);
        name.split('(').next().unwrap_or(name)
    }
}

impl Wgsl {
    /// Returns these modules of `shaders/`.
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
