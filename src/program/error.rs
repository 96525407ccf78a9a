//! What can go wrong between a scene and its program.

use thiserror::Error;

use super::place::Place;

/// A program that could not be linked or is not valid. Scenes of built-in parts alone cause only the last.
#[derive(Debug, Error)]
pub enum ProgramError {
    /// A part that does not exist was asked for.
    #[error("there is no shader part `{0}`")]
    NoPart(String),
    /// Two of the parts chosen declare the same name.
    #[error("{place}: `{name}` is already declared in {other}")]
    Twice {
        /// Where it is declared: of two places the user's own.
        place: Place,
        /// The name.
        name: String,
        /// The file that declares it too.
        other: String,
    },
    /// A name that the linker makes for its own use.
    #[error("{place}: `{name}` is a name that programs use for something else: choose another")]
    Reserved {
        /// Where it is.
        place: Place,
        /// The name.
        name: String,
    },
    /// The entry point is in none of the parts.
    #[error("no part declares the entry point `{0}`")]
    NoEntry(String),
    /// A name with a copy per region that is no function, or one whose signature needs a type that has copies itself.
    #[error(
        "{place}: `{name}` has a copy for each kind of region, but is used by all: only functions over shared types can be chosen between"
    )]
    NotSwitchable {
        /// Where it is declared.
        place: Place,
        /// The name.
        name: String,
    },
    /// The WGSL is not valid.
    #[error("{place}: {message}")]
    Invalid {
        /// The place in the file that it was written in.
        place: Place,
        /// What is wrong there.
        message: String,
    },
    /// A binding that is neither the renderer's nor a value of the scene, or of a type that no pass binds.
    #[error("{place}: the renderer has nothing to bind to `{name}`")]
    UnknownBinding {
        /// Where it is declared.
        place: Place,
        /// The variable.
        name: String,
    },
    /// More items than a primitive's word tells apart.
    #[error(
        "the scene shows {items} triangles and other shapes in its structure, and {most} can be told apart: show fewer"
    )]
    TooManyItems {
        /// So many.
        items: u64,
        /// So many there may be.
        most: u64,
    },
}

impl ProgramError {
    pub(super) fn invalid(place: Place, message: String) -> Self {
        Self::Invalid { place, message }
    }
}
