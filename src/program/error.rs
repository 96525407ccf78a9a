//! Errors that prevent a scene from becoming a program.

use thiserror::Error;

use super::location::Location;

/// A program that could not be linked or is not valid. Scenes of built-in modules alone cause only the last of these errors.
#[derive(Debug, Error)]
pub enum ProgramError {
    /// A module that does not exist was requested.
    #[error("unknown shader module `{0}`")]
    NoPart(String),
    /// Two of the chosen modules declare the same name.
    #[error("{place}: `{name}` is already declared in {other}")]
    Twice {
        /// The location of the declaration; of two locations, the one in the user's file.
        place: Location,
        /// The name.
        name: String,
        /// The other file that declares it.
        other: String,
    },
    /// A name that the linker reserves for itself.
    #[error("{place}: the name `{name}` is reserved by the renderer; choose another name")]
    Reserved {
        /// The location of the name.
        place: Location,
        /// The name.
        name: String,
    },
    /// None of the modules contains the entry point.
    #[error("no shader module declares the entry point `{0}`")]
    NoEntry(String),
    /// A name with a copy per region that is not a function, or a function whose signature needs a type that has copies itself.
    #[error(
        "{place}: `{name}` has a copy for each kind of region, but shared code uses it; only functions with shared \
         types can be selected per region"
    )]
    NotSwitchable {
        /// The location of the declaration.
        place: Location,
        /// The name.
        name: String,
    },
    /// The WGSL is not valid.
    #[error("{place}: {message}")]
    Invalid {
        /// The location in the original file.
        place: Location,
        /// The problem.
        message: String,
    },
    /// A binding that is neither the renderer's nor a value of the scene, or has a type that no pass binds.
    #[error("{place}: the renderer provides no resource for the binding `{name}`")]
    UnknownBinding {
        /// The location of the declaration.
        place: Location,
        /// The variable.
        name: String,
    },
    /// More items than the bits of a primitive can distinguish.
    #[error(
        "the scene has {items} primitives in its acceleration structure, but at most {most} are supported; use fewer \
         triangles or objects"
    )]
    TooManyItems {
        /// The number of items in the scene.
        items: u64,
        /// The largest possible number.
        most: u64,
    },
}

impl ProgramError {
    pub(super) fn invalid(place: Location, message: String) -> Self {
        Self::Invalid { place, message }
    }
}
