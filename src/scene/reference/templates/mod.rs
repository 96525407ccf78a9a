//! Scenes to start from, which `bentray new` writes.

/// A scene with comments.
#[derive(Debug, Clone, Copy)]
pub struct Template {
    /// What `--template` calls it.
    pub name: &'static str,
    /// What it shows, in a few words.
    pub about: &'static str,
    /// The file.
    pub text: &'static str,
}

macro_rules! templates {
    ($($name:literal: $about:literal,)*) => {
        /// All of them; the first is the usual one.
        pub const TEMPLATES: &[Template] =
            &[$(Template { name: $name, about: $about, text: include_str!(concat!($name, ".toml")) }),*];
    };
}

templates! {
    "black-hole": "a black hole before a chequered sphere, with a comment on every line",
    "kerr": "a hole that spins, with a disc of matter round it",
    "lens": "a ball of varying index on a chequered floor",
    "force": "light that is drawn to a line and pushed off by a centre",
    "flow": "rays that follow the flow of the Lorenz system",
    "paths": "a room with a lamp and a glass ball, light from wall to wall",
}
