//! Units: pieces of WGSL that programs are linked from, each with a name for errors.

use std::borrow::Cow;

use super::{DeviceProfile, ShaderModule};

/// A piece of WGSL: a built-in module, text generated for a scene, or a user's file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit {
    /// The file: `law/sources.wgsl`, `generated/shapes.wgsl`, or the path of a user's file as it was given.
    pub file: Cow<'static, str>,
    /// The WGSL.
    pub text: Cow<'static, str>,
    /// The author.
    pub author: Author,
}

/// The author of a piece of WGSL; of several locations, errors report the user's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Author {
    /// A file of `shaders/`.
    BuiltIn,
    /// Text that was generated for a scene.
    Generated,
    /// A file or a string that a user wrote.
    User,
}

impl Unit {
    /// Creates a unit of text that was generated for a scene.
    #[must_use]
    pub fn generated(file: &'static str, text: String) -> Self {
        Self { file: file.into(), text: text.into(), author: Author::Generated }
    }

    /// Creates a unit of a user's text; errors name `file` as it is given here.
    #[must_use]
    pub fn user(file: impl Into<Cow<'static, str>>, text: impl Into<Cow<'static, str>>) -> Self {
        Self { file: file.into(), text: text.into(), author: Author::User }
    }

    /// Returns the name in messages, by which a reader finds the file.
    #[must_use]
    pub fn shown(&self) -> String {
        if self.author == Author::BuiltIn { format!("shaders/{}", self.file) } else { self.file.to_string() }
    }
}

impl From<ShaderModule> for Unit {
    fn from(part: ShaderModule) -> Self {
        Self { file: part.file.into(), text: part.text.into(), author: Author::BuiltIn }
    }
}

/// The units that a scene's program is linked from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Parts {
    /// The units that all regions share.
    pub shared: Vec<Unit>,
    /// The units of each kind of region; if there are several kinds, each gets a copy.
    pub regions: Vec<Vec<Unit>>,
    /// The lengths of the scene's lists that may be short.
    pub lengths: Vec<(&'static str, usize)>,
    /// The device that they are linked for.
    pub device: DeviceProfile,
}
