//! Selects the part of an image to render.
//!
//! *Theory.* The rays of a pixel depend only on its position in the whole image. Therefore any division into windows (to share an image
//! between machines) and tiles (to fit it into memory) gives identical bits.

use std::fmt;

/// A rectangle of an image, in pixels from its top left corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Window {
    /// The left column and the top row.
    pub origin: [u32; 2],
    /// The width and the height, neither zero.
    pub size: [u32; 2],
}

impl Window {
    /// Returns the window of a whole image.
    #[must_use]
    pub fn whole(size: [u32; 2]) -> Self {
        Self { origin: [0, 0], size }
    }

    /// Returns `true` if the window is inside an image of this size, or all of it.
    #[must_use]
    pub fn fits(self, picture: [u32; 2]) -> bool {
        (0..2).all(|k| u64::from(self.origin[k]) + u64::from(self.size[k]) <= u64::from(picture[k]))
    }
}

impl fmt::Display for Window {
    /// Writes the window in the format of `--crop`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { origin: [x, y], size: [width, height] } = self;
        write!(f, "{x},{y},{width}x{height}")
    }
}
