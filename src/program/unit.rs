//! What programs are linked from: pieces of WGSL, each with a name for errors.

use std::borrow::Cow;

use super::{DeviceProfile, Part};

/// A piece of WGSL: a part, text generated for a scene, or a user's own file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit {
    /// `law/sources.wgsl`, `generated/shapes.wgsl`, or the path of a user's file as it was given.
    pub file: Cow<'static, str>,
    /// The WGSL.
    pub text: Cow<'static, str>,
    /// Who wrote it.
    pub author: Author,
}

/// Who wrote a piece of WGSL: errors are first of all a user's own to mend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Author {
    /// A file of `shaders/`.
    BuiltIn,
    /// Made for a scene.
    Generated,
    /// A file or a string that a user wrote.
    User,
}

impl Unit {
    /// Text made for a scene.
    #[must_use]
    pub fn generated(file: &'static str, text: String) -> Self {
        Self { file: file.into(), text: text.into(), author: Author::Generated }
    }

    /// A user's own text; errors name `file` as it is given here.
    #[must_use]
    pub fn user(file: impl Into<Cow<'static, str>>, text: impl Into<Cow<'static, str>>) -> Self {
        Self { file: file.into(), text: text.into(), author: Author::User }
    }

    /// Its name in messages, where a reader finds it.
    #[must_use]
    pub fn shown(&self) -> String {
        if self.author == Author::BuiltIn { format!("shaders/{}", self.file) } else { self.file.to_string() }
    }
}

impl From<Part> for Unit {
    fn from(part: Part) -> Self {
        Self { file: part.file.into(), text: part.text.into(), author: Author::BuiltIn }
    }
}

/// What a scene's program is linked from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Parts {
    /// Parts that all regions share.
    pub shared: Vec<Unit>,
    /// The parts of each kind of region; with more than one kind each gets a copy of its own.
    pub regions: Vec<Vec<Unit>>,
    /// How long the scene's lists are that may be short.
    pub lengths: Vec<(&'static str, usize)>,
    /// What they are linked for.
    pub device: DeviceProfile,
}
