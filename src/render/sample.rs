//! Describes one sample of a tile for its passes.

use crate::model::Value::{self, Uint, Uint2};
use crate::program::{Features, constant};

/// A sample of a part of the image.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// The tile's first pixel in the whole image.
    pub origin: [u32; 2],
    /// The size of the whole image, in pixels.
    pub image: [u32; 2],
    /// The index of the sample in each pixel.
    pub number: u32,
    /// `true` for the rays through the centers of pixels, which do not count as a sample.
    pub is_grid: bool,
    /// `true` if only the ends of the rays are wanted, and nothing between them.
    pub ends_only: bool,
    /// The pixels that the sample refines, in an adaptive image.
    pub refines: Option<Refines>,
}

/// The pixels that take a sample, and the list of pixels that need more.
#[derive(Debug, Clone, Copy)]
pub(super) struct Refines {
    /// `true` if only listed pixels take it, `false` if all pixels of the tile do.
    pub listed: bool,
    /// The number of their list; the next list contains those that continue.
    pub list: u64,
}

impl Refines {
    /// The sample after the rays through the corners, which have no list.
    pub(super) const FIRST: Self = Self { listed: false, list: 1 };
}

impl Sample {
    /// Returns the sample of the grid of rays through the centers of pixels, at the moment of the sample `number`. They do not count as samples
    /// of a pixel.
    pub(super) fn grid(self) -> Self {
        Self { is_grid: true, ..self }
    }

    /// Returns `true` if the rays of the sample are the grid.
    pub(super) fn is_grid_of(&self, features: &Features) -> bool {
        !self.ends_only && (self.is_grid || features.samples_grid(self.number))
    }

    /// Returns the first sample of every pixel, in a tile at the origin of the image.
    pub(super) fn first(image: [u32; 2]) -> Self {
        Self { origin: [0, 0], image, number: 0, is_grid: false, ends_only: false, refines: None }
    }

    /// Returns the sample of a tile with a margin of this many pixels to the left and above.
    pub(super) fn before(self, margin: u32) -> Self {
        Self { origin: self.origin.map(|at| at.wrapping_sub(margin)), ..self }
    }

    /// Returns the members of `shaders/state/arguments.wgsl` in a round of the sample.
    pub(super) fn row(self, tile: [u32; 2], round: u32) -> [(&'static str, Value); 7] {
        let listed = round > 0 || self.refines.is_some_and(|refines| refines.listed);
        [
            ("origin", Uint2(self.origin)),
            ("size", Uint2(tile)),
            ("image", Uint2(self.image)),
            (
                "sample",
                Uint(if self.is_grid { constant("camera/sample/point", "CENTERS") as u32 } else { self.number }),
            ),
            ("branch", Uint(round.min(1))),
            ("listed", Uint(listed.into())),
            ("zero", Uint(0)),
        ]
    }
}
