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
    "black-hole": "a black hole in front of a checkered sphere, with a comment on every line",
    "kerr": "a rotating black hole with a thin accretion disk",
    "lens": "a sphere with a varying refractive index on a checkered floor",
    "force": "light attracted by a line and repelled by a center",
    "flow": "rays that follow the flow of the Lorenz system",
    "paths": "a room with an area light and a glass sphere, rendered by path tracing",
}
