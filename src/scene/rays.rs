//! `[rays]`: how rays are followed.

use glam::DVec3;

use crate::model::{Control, Law, Method};

/// `[rays]`: how rays are followed.
#[derive(Debug, Clone, PartialEq)]
pub struct Rays {
    /// The integrator.
    pub method: Method,
    /// How long its steps are.
    pub control: Control,
    /// What a calibration shall find, where the scene leaves method and control to one; until that has run they are RK4's.
    pub auto: Option<Auto>,
    /// What is tested against the scene.
    pub segment: Segment,
    /// A ray that has this many segments and is still under way is exhausted.
    pub max_segments: u32,
    /// Rays that leave this sphere have escaped.
    pub bound: Bound,
    /// Rays end at this τ.
    pub length: Option<f64>,
    /// Outside the bounding sphere rays are followed to infinity in closed form.
    pub asymptotic: bool,
    /// Bits of the numbers.
    pub precision: Precision,
    /// Where a medium's paths have a closed form it stands for the method.
    pub closed_forms: bool,
    /// Does one step lead through a region that has nothing else in it? Paths that are to be drawn are cut into arcs.
    pub leaps: bool,
    /// How the rays that a surface splits are followed.
    pub branches: Branches,
    /// How the objects that a segment may meet are searched.
    pub accelerate: Accelerate,
    /// Does light go from surface to surface, and how far? Else what surfaces show is the light of the scene's lights.
    pub paths: Option<Paths>,
    /// Of light, nanometers, where it is not drawn; it matters to dispersion alone.
    pub wavelength: f64,
}

/// `[path_tracing]`: how paths are followed from surface to surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Paths {
    /// Surfaces that send a path on, at most; as many as light needs without.
    pub depth: Option<u32>,
    /// Surfaces that send it on before roulette may end it.
    pub roulette: u32,
    /// Does one more ray leave each place towards the lamps?
    pub aim: bool,
    /// Is light followed from the lamps first, to guide those rays where cones about lamps do not lead?
    pub guide: bool,
    /// What its random numbers begin with.
    pub seed: u32,
}

impl Default for Paths {
    fn default() -> Self {
        Self { depth: None, roulette: 4, aim: true, guide: true, seed: 0 }
    }
}

/// What stands between a segment and the objects. All give the same picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Accelerate {
    /// What measures best.
    Auto,
    /// A bounding volume hierarchy.
    Hierarchy,
    /// A uniform grid (G95 §4).
    Grid,
    /// Nothing: every segment is tested against every object (W04).
    None,
}

/// What is followed where a surface both reflects and transmits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branches {
    /// Both, exactly, up to so many times along a path: what would split once more is cut.
    Enumerated(u32),
    /// One of them at random, a sample.
    Random,
}

/// What is left to a calibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Auto {
    /// How accurate rays shall be.
    pub accuracy: Accuracy,
    /// Are the bits of the numbers left to it too? 64 where 32 do not reach the accuracy.
    pub precision: bool,
}

/// The error in a ray's direction that 99 of 100 rays shall stay under.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// In parts of the angle of a pixel at the picture's center.
    Pixels(f64),
    /// In radians.
    Radians(f64),
}

/// What of a path is tested against the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Segment {
    /// One accepted step as a cubic Hermite arc, cut into chords that stay within `tolerance` of it.
    Arc {
        /// Scene units.
        tolerance: f64,
    },
    /// The paper's polygon: one chord over N steps.
    Chord {
        /// N.
        steps: u32,
    },
}

impl Segment {
    /// Is it the paper's polygon?
    #[must_use]
    pub fn has_chords(self) -> bool {
        matches!(self, Self::Chord { .. })
    }
}

/// The bounding sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Its center.
    pub center: DVec3,
    /// Its radius.
    pub radius: f64,
}

impl Bound {
    /// Its center, and where the law leads to another side that of the sphere there.
    #[must_use]
    pub fn centers(&self, law: Option<&dyn Law>) -> Vec<DVec3> {
        let throat = law.and_then(|law| law.facts().throat);
        let there = throat.map(|throat| self.center + throat.mouths[1] - throat.mouths[0]);
        std::iter::once(self.center).chain(there).collect()
    }
}

/// Bits of the numbers that a path is followed in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Precision {
    /// Followed in 32 bits, kept between passes in 16, as in 2004.
    Half,
    /// 32.
    Single,
    /// 64, where the device has them.
    Double,
}

impl Precision {
    /// All, from the fewest bits to the most.
    pub const ALL: [Self; 3] = [Self::Half, Self::Single, Self::Double];

    /// As users write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Half => "f16",
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }

    /// In a few words.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Half => "32 bits, kept in 16 between passes as in 2004",
            Self::Single => "32 bits",
            Self::Double => "64 bits, where the device has them",
        }
    }
}
