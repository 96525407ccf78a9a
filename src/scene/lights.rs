//! Lights, and how it is found out what they reach.

use std::ops::RangeInclusive;

use glam::DVec3;

use super::Scene;

/// `[[lights]]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Where it is.
    pub source: LightSource,
    /// The radiance of a white surface that faces it; at distance 1, if it falls off.
    pub color: DVec3,
    /// How it is found out whether it reaches a surface.
    pub shadows: Shadows,
    /// Where its shadows are straight: what clear things do to its light.
    pub clear: Clear,
    /// Does it fall off with the square of the distance; found by shooting, with the spread of its bundle?
    pub falls: bool,
    /// The radius of the ball that it is: as bright as that at a caustic.
    pub size: f64,
    /// How finely its light is kept, where that is in a grid.
    pub grid: LightGrid,
}

/// How finely a light's light is kept in voxels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LightGrid {
    /// Voxels along the longest side of what is lit.
    pub voxels: u32,
    /// Parts along each axis of voxels that disagree with their neighbors; 1 for none.
    pub refine: u32,
    /// Paths to what is lit; to the parts there are four times as many.
    pub paths: u32,
}

impl LightGrid {
    /// The cheapest there is.
    pub const COARSEST: Self = Self { voxels: 8, refine: 1, paths: 1024 };
}

/// Paths, at least, where a scene does not say.
const FEWEST_PATHS: u32 = 1 << 16;

impl LightGrid {
    /// As many paths as leave less noise with finer voxels: to twice as fine ones eight times as many, twice through each.
    #[must_use]
    pub fn usual_paths(voxels: u32) -> u32 {
        voxels.saturating_pow(3).saturating_mul(2).clamp(FEWEST_PATHS, *PATHS.end())
    }
}

/// What a scene may ask for.
pub(super) const PATHS: RangeInclusive<u32> = 1024..=1 << 26;

impl Default for LightGrid {
    fn default() -> Self {
        Self { voxels: 64, refine: 4, paths: Self::usual_paths(64) }
    }
}

/// Where light comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LightSource {
    /// A place.
    Point(DVec3),
    /// Far away: the unit vector that the light travels along.
    Directional(DVec3),
}

/// How it is found out whether a light reaches a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shadows {
    /// It reaches all that faces it (W04 §3.4: "fake" illumination, for testing).
    None,
    /// By straight lines, whatever the law (G95 §6).
    Straight,
    /// By the paths of the scene's own law that lead from the light to the surface.
    Shooting,
    /// By what paths of the scene's own law from the light have left in the voxels of a grid (G95 §6).
    Grid,
}

/// What clear things do to light that comes in a straight line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clear {
    /// They let it through undiminished.
    Open,
    /// They let through as much as their surfaces transmit and their media leave, with its color, straight on.
    Filtered,
    /// They shut it out as what is opaque does.
    Closed,
}

impl Clear {
    /// The words for it in a scene's file.
    pub(super) const WORDS: [(&str, Self); 3] =
        [("ignored", Self::Open), ("tinted", Self::Filtered), ("opaque", Self::Closed)];
}

impl Shadows {
    /// Is its light bent as the camera's rays are?
    #[must_use]
    pub fn follows_the_law(self) -> bool {
        matches!(self, Self::Shooting | Self::Grid)
    }
}

impl Light {
    /// White, without shadows or fall-off.
    #[must_use]
    pub fn new(source: LightSource) -> Self {
        let (shadows, grid) = (Shadows::None, LightGrid::default());
        Self { source, color: DVec3::ONE, shadows, clear: Clear::Open, falls: false, size: 0.0, grid }
    }

    /// Is it in a grid as bright as its paths are many? How bright light from far away is follows from them wherever the law bends it to.
    #[must_use]
    pub fn falls_in_grid(&self) -> bool {
        self.falls || !self.is_point()
    }

    /// Is it at a place?
    #[must_use]
    pub fn is_point(&self) -> bool {
        matches!(self.source, LightSource::Point(_))
    }
}

impl Scene {
    /// Does a surface that shows lights show one with these shadows?
    #[must_use]
    pub fn has_shadows(&self, kind: Shadows) -> bool {
        self.is_lit() && self.lights.iter().any(|light| light.shadows == kind)
    }

    /// Is ambient light shut out where a surface shows it?
    #[must_use]
    pub fn is_occluded(&self) -> bool {
        self.occlusion.is_some() && self.used_materials().any(|material| material.surface.facts().is_lit)
    }

    /// What clear things do to light that comes in straight lines, of each light and of ambient light.
    pub fn lines(&self) -> impl Iterator<Item = Clear> {
        let straight = |light: &&Light| self.is_lit() && light.shadows == Shadows::Straight;
        let ambient = self.occlusion.filter(|occlusion| self.is_occluded() && !occlusion.along_law);
        let ambient = ambient.map(|occlusion| occlusion.clear);
        self.lights.iter().filter(straight).map(|light| light.clear).chain(ambient)
    }

    /// Do clear things shut out light that comes in straight lines?
    #[must_use]
    pub fn shuts_out(&self) -> bool {
        self.splits() && self.lines().any(|clear| clear == Clear::Closed)
    }

    /// Is there something that weakens light that comes in straight lines?
    #[must_use]
    pub fn weakens_lines(&self) -> bool {
        (self.splits() || self.filter.is_some()) && self.lines().any(|clear| clear == Clear::Filtered)
    }
}
