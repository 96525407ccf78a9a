//! What can go wrong between a scene and its program.

use thiserror::Error;

/// A program that could not be linked or is not valid. Scenes cannot cause the first five: they are slips in a part.
#[derive(Debug, Error)]
pub enum ProgramError {
    /// A part that does not exist was asked for.
    #[error("there is no shader part `{0}`")]
    NoPart(String),
    /// Two of the parts chosen declare the same name.
    #[error("both {first} and {second} declare `{name}`")]
    Twice {
        /// The name.
        name: String,
        /// Where it is declared first.
        first: String,
        /// Where it is declared again.
        second: String,
    },
    /// The entry point is in none of the parts.
    #[error("no part declares the entry point `{0}`")]
    NoEntry(String),
    /// A name with a copy per region that is no function, or one whose signature needs a type that has copies itself.
    #[error(
        "{file}: `{name}` has a copy for each kind of region, but is used by all: only functions over shared types can be chosen between"
    )]
    NotSwitchable {
        /// The part.
        file: String,
        /// The name.
        name: String,
    },
    /// naga refused the program; the place is the part's own.
    #[error("{file}:{line}:{column}: {message}")]
    Invalid {
        /// The part.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// Its column, from 1.
        column: usize,
        /// naga's explanation.
        message: String,
    },
    /// A binding that is neither the renderer's nor a value of the scene, or of a type that no pass binds.
    #[error("{file}:{line}: the renderer has nothing to bind to `{name}`")]
    UnknownBinding {
        /// The part.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// The variable.
        name: String,
    },
    /// One segment may need more loop iterations than a software device grants an invocation.
    #[error(
        "one segment of this scene may need {needed} loop iterations, and an invocation has {limit}: \
         use fewer {what}, or fewer steps a segment"
    )]
    TooMuchWork {
        /// Iterations of the worst segment.
        needed: u64,
        /// Iterations there may be.
        limit: u64,
        /// What there are too many of.
        what: &'static str,
    },
}
