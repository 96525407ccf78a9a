//! Which part of a picture is rendered.
//!
//! *Theory.* A pixel's rays depend on its place in the whole picture and on nothing beside it, so that any cut into windows
//! (to share a picture between machines) and tiles (to fit it into memory) gives the same bits.

use std::fmt;

/// A rectangle of a picture, in pixels from its top left corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Window {
    /// Its left column and top row.
    pub origin: [u32; 2],
    /// Its width and height, neither zero.
    pub size: [u32; 2],
}

impl Window {
    /// A whole picture.
    #[must_use]
    pub fn whole(size: [u32; 2]) -> Self {
        Self { origin: [0, 0], size }
    }

    /// Is it inside a picture of this size? It may be all of it.
    #[must_use]
    pub fn fits(self, picture: [u32; 2]) -> bool {
        (0..2).all(|k| u64::from(self.origin[k]) + u64::from(self.size[k]) <= u64::from(picture[k]))
    }
}

impl fmt::Display for Window {
    /// As `--crop` takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { origin: [x, y], size: [width, height] } = self;
        write!(f, "{x},{y},{width}x{height}")
    }
}
