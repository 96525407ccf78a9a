//! The grid of rays through the centers of pixels, between which bundles of light are measured and stars are found, and the margin around a
//! tile.

use super::Features;
use crate::program::{Layer, Mode, PathEnds, ProgramOptions, constant};
use crate::scene::Scene;

/// The need for a grid in an image.
#[expect(clippy::struct_excessive_bools, reason = "each is a separate question")]
pub(super) struct GridFeatures {
    /// Stars, footprints or layers of bundles need the grid.
    pub exists: bool,
    /// The sky has stars.
    pub has_stars: bool,
    /// The first sample of each pixel is at its center.
    pub centers_first: bool,
    /// That sample is the ray of the grid.
    pub is_sample: bool,
    /// The footprints of pixels are computed; a map of path ends is for images of other scenes, too.
    pub keeps_footprints: bool,
}

impl GridFeatures {
    pub(super) fn of(scene: &Scene, ProgramOptions { mode, layers, ends, .. }: &ProgramOptions) -> Self {
        if *mode != Mode::Picture {
            return Self {
                exists: false,
                has_stars: false,
                centers_first: false,
                is_sample: false,
                keeps_footprints: false,
            };
        }
        let filters = scene.has_footprints();
        let keeps_footprints = filters || *ends == PathEnds::Stored;
        let has_stars = *ends == PathEnds::Followed && scene.has_stars();
        let describes = |layer: &Layer| layer.is_of_bundles() && layer.refused_by(scene).is_none();
        let is_needed = |footprints: bool| has_stars || footprints || layers.iter().any(describes);
        // The light of the sky is added after all rays have ended if nothing else is filtered, and if light is not divided by frequency or
        // order.
        let can_wait = !scene.filters_surfaces() && scene.radiation.is_none() && !layers.contains(&Layer::ImageOrder);
        // The first rays of an adaptive image are those through the corners of its pixels. A map has the samples of its own scene.
        let centers_first = is_needed(filters) && scene.image.adaptive.is_none() && (!filters || can_wait);
        Self {
            exists: is_needed(keeps_footprints) && *ends != PathEnds::Given,
            has_stars,
            centers_first,
            is_sample: centers_first && *ends == PathEnds::Followed,
            keeps_footprints,
        }
    }
}

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
    /// Returns `true` if the bundle of light of each pixel is stored for its samples.
    #[must_use]
    pub fn keeps_bundles(&self) -> bool {
        self.keeps_footprints && self.has_grid && !self.sample_is_grid
    }

    /// Returns `true` if the rays of the sample with this number are the grid.
    #[must_use]
    pub fn samples_grid(&self, number: u32) -> bool {
        self.first_is_grid && number == 0
    }

    /// Returns `true` if layers describe the bundles of light of pixels.
    #[must_use]
    pub fn describes_bundles(&self) -> bool {
        self.has_grid && self.layers.iter().any(|layer| layer.is_of_bundles())
    }

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
