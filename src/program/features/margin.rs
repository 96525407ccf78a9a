//! The margin around the pixels of a tile.

use super::Features;
use crate::program::constant;

/// The numbers of extra columns or rows of a tile, on both sides of its pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Margin {
    /// To the left and above.
    pub before: u32,
    /// To the right and below.
    pub after: u32,
}

impl Margin {
    /// Returns the sum of both sides.
    #[must_use]
    pub fn total(self) -> u32 {
        self.before + self.after
    }
}

impl Features {
    /// Returns the number of extra columns and rows of a tile: a grid continues on all sides, and the corners of the last pixels of an
    /// adaptive image are shared with the next pixels.
    #[must_use]
    pub fn margin(&self) -> Margin {
        if self.has_grid {
            let name = if self.has_stars { "STAR_MARGIN" } else { "BUNDLE_MARGIN" };
            let side = constant("picture/bundle/grid", name) as u32;
            return Margin { before: side, after: side };
        }
        Margin { before: 0, after: self.adapts.into() }
    }
}
