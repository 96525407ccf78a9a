//! Templates of scenes, which `bentray new` writes.

/// A scene file with comments.
#[derive(Debug, Clone, Copy)]
pub struct Template {
    /// The name for `--template`.
    pub name: &'static str,
    /// A short description of the scene.
    pub about: &'static str,
    /// The text of the file.
    pub text: &'static str,
}

macro_rules! templates {
    ($($name:literal: $about:literal,)*) => {
        /// All templates; the first is the default.
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
