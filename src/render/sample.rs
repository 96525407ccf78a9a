//! One sample of a tile: what its passes are told.

use crate::model::Value::{self, Uint, Uint2};
use crate::program::constant;

/// A part of the picture and a sample of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// The tile's first pixel in the whole picture.
    pub origin: [u32; 2],
    /// The whole picture's size.
    pub image: [u32; 2],
    /// Which of each pixel's samples.
    pub number: u32,
    /// In an adaptive picture, for which pixels the sample is.
    pub refines: Option<Refines>,
}

/// The pixels that take a sample, and those of them that will take more.
#[derive(Debug, Clone, Copy)]
pub(super) struct Refines {
    /// Are they listed, or every one of the tile?
    pub listed: bool,
    /// The number of their list; the next one is of those that go on.
    pub list: u64,
}

impl Refines {
    /// After the rays through the corners, of which there is no list.
    pub(super) const FIRST: Self = Self { listed: false, list: 1 };
}

impl Sample {
    /// Rays through the corners of pixels, which are no samples of theirs.
    pub(super) fn corners(origin: [u32; 2], image: [u32; 2]) -> Self {
        let number = constant("camera/sample/point", "CORNERS") as u32;
        Self { origin, image, number, refines: None }
    }

    /// The first of every pixel, in a tile that begins where the picture does.
    pub(super) fn first(image: [u32; 2]) -> Self {
        Self { origin: [0, 0], image, number: 0, refines: None }
    }

    /// The members of `shaders/state/arguments.wgsl` in a round of the sample.
    pub(super) fn row(self, tile: [u32; 2], round: u32) -> [(&'static str, Value); 7] {
        let listed = round > 0 || self.refines.is_some_and(|refines| refines.listed);
        [
            ("origin", Uint2(self.origin)),
            ("size", Uint2(tile)),
            ("image", Uint2(self.image)),
            ("sample", Uint(self.number)),
            ("branch", Uint(round.min(1))),
            ("listed", Uint(listed.into())),
            ("zero", Uint(0)),
        ]
    }
}
