//! Lights and their shadows.

use std::ops::RangeInclusive;

use glam::DVec3;

use super::Scene;

/// A table `[[lights]]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// The position or direction.
    pub source: LightSource,
    /// The radiance of a white surface that faces the light; at distance 1, if the light falls off.
    pub color: DVec3,
    /// The method that computes shadows.
    pub shadows: Shadows,
    /// The effect of transparent objects, for straight shadows.
    pub transparent: TransparentShadows,
    /// Is `true` if the light falls off with the square of the distance or, with the shooting method, with the divergence of its ray
    /// bundle.
    pub falls: bool,
    /// The minimum effective distance, which limits the brightness at caustics.
    pub min_distance: f64,
    /// The resolution of the light grid, if shadows use one.
    pub grid: LightGrid,
}

/// The resolution of a light grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LightGrid {
    /// The number of voxels along the longest side of the lit region.
    pub voxels: u32,
    /// The subdivision along each axis of voxels that differ from their neighbors; 1 for none.
    pub refine: u32,
    /// The number of paths to the lit region; subdivided voxels use four times as many.
    pub paths: u32,
}

impl LightGrid {
    /// The cheapest resolution.
    pub const COARSEST: Self = Self { voxels: 8, refine: 1, paths: 1024 };
}

/// The minimum default number of paths.
const FEWEST_PATHS: u32 = 1 << 16;

impl LightGrid {
    /// Returns a default number of paths that limits the noise of finer voxels: eight times as many for half the size, twice as many per
    /// voxel.
    #[must_use]
    pub fn usual_paths(voxels: u32) -> u32 {
        voxels.saturating_pow(3).saturating_mul(2).clamp(FEWEST_PATHS, *PATHS.end())
    }
}

/// The range of paths that a scene may specify.
pub(super) const PATHS: RangeInclusive<u32> = 1024..=1 << 26;

impl Default for LightGrid {
    fn default() -> Self {
        Self { voxels: 64, refine: 4, paths: Self::usual_paths(64) }
    }
}

/// The position or direction of a light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LightSource {
    /// A point light at a position.
    Point(DVec3),
    /// A directional light: the unit vector along which the light travels.
    Directional(DVec3),
}

/// The method that decides whether a light reaches a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shadows {
    /// Without shadows: the light reaches every surface that faces it (W04 §3.4: "fake" illumination, for testing).
    None,
    /// Along straight lines, whatever the law (G95 §6).
    Straight,
    /// Along the law's paths from the light to the surface, found by the shooting method.
    Shooting,
    /// A grid of voxels stores the paths from the light under the law (G95 §6).
    Grid,
}

/// The effect of transparent objects on light along a straight line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TransparentShadows {
    /// Light passes unchanged.
    Open,
    /// Light continues straight, tinted by the transmittance of surfaces and media.
    Filtered,
    /// Light is blocked as by opaque objects.
    Closed,
}

impl TransparentShadows {
    /// The names in a scene file.
    pub(super) const WORDS: [(&str, Self); 3] =
        [("ignored", Self::Open), ("tinted", Self::Filtered), ("opaque", Self::Closed)];
}

impl Shadows {
    /// Returns `true` if the light bends like camera rays.
    #[must_use]
    pub fn follows_the_law(self) -> bool {
        matches!(self, Self::Shooting | Self::Grid)
    }
}

impl Light {
    /// Creates a white light without shadows or fall-off; its fields are public. Positions are in scene units, and directions are unit
    /// vectors.
    #[must_use]
    pub fn new(source: LightSource) -> Self {
        let (shadows, grid) = (Shadows::None, LightGrid::default());
        Self {
            source,
            color: DVec3::ONE,
            shadows,
            transparent: TransparentShadows::Open,
            falls: false,
            min_distance: 0.0,
            grid,
        }
    }

    /// Returns `true` if its brightness in a grid follows from the density of its paths. For a directional light this includes the focusing
    /// by the law.
    #[must_use]
    pub fn falls_in_grid(&self) -> bool {
        self.falls || !self.is_point()
    }

    /// Returns `true` if the light is a point light.
    #[must_use]
    pub fn is_point(&self) -> bool {
        matches!(self.source, LightSource::Point(_))
    }
}

impl Scene {
    /// Returns `true` if a lit surface shows a light with this kind of shadows.
    #[must_use]
    pub fn has_shadows(&self, kind: Shadows) -> bool {
        self.is_lit() && self.lights.iter().any(|light| light.shadows == kind)
    }

    /// Returns `true` if a surface shows ambient occlusion.
    #[must_use]
    pub fn is_occluded(&self) -> bool {
        self.occlusion.is_some() && self.used_materials().any(|material| material.surface.facts().is_lit)
    }

    /// Returns the effect of transparent objects on straight light, for each light and for ambient light.
    pub fn lines(&self) -> impl Iterator<Item = TransparentShadows> {
        let straight = |light: &&Light| self.is_lit() && light.shadows == Shadows::Straight;
        let ambient = self.occlusion.filter(|occlusion| self.is_occluded() && !occlusion.along_law);
        let ambient = ambient.map(|occlusion| occlusion.clear);
        self.lights.iter().filter(straight).map(|light| light.transparent).chain(ambient)
    }

    /// Returns `true` if transparent objects block straight light.
    #[must_use]
    pub fn shuts_out(&self) -> bool {
        self.splits() && self.lines().any(|clear| clear == TransparentShadows::Closed)
    }

    /// Returns `true` if something attenuates straight light.
    #[must_use]
    pub fn weakens_lines(&self) -> bool {
        (self.splits() || self.absorption.is_some() || !self.volumes.is_empty())
            && self.lines().any(|clear| clear == TransparentShadows::Filtered)
    }
}
