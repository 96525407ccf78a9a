//! Textures of filters: noise as a share from 0 to 1, and what color that is.

use glam::DVec3;

use crate::model::{Row, row};

/// A color by fractal noise, which is left after a unit length.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// What color a share of the noise is.
    pub look: Look,
    /// Lattice cells a unit length; of marble also waves of 2π.
    pub frequency: f64,
    /// Terms of the noise, 1 to 8.
    pub octaves: u32,
    /// Chooses it.
    pub seed: u32,
}

/// What color a share from 0 to 1 is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Look {
    /// Between two.
    Mix([DVec3; 2]),
    /// Between two, so many times over.
    Wrapped([DVec3; 2], f64),
    /// Seven colors.
    Rainbow,
    /// A picture's, from left to right: index into the scene's.
    Ramp(usize),
    /// A picture's, in waves along an axis that the noise, times a number, disturbs.
    Marble(usize, DVec3, f64),
}

impl Texture {
    /// The name of its density in WGSL.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self.look {
            Look::Mix(_) => "mix",
            Look::Wrapped(..) => "wrapped",
            Look::Rainbow => "rainbow",
            Look::Ramp(_) => "ramp",
            Look::Marble(..) => "marble",
        }
    }

    /// A cell of the finest octave: pieces of a path are no longer than that to begin with.
    fn piece(&self) -> f64 {
        1.0 / (self.frequency * f64::from(1 << (self.octaves - 1)))
    }

    /// The members of `Filter` that are its own.
    #[must_use]
    pub fn values(&self) -> Row {
        let own = match self.look {
            Look::Mix([low, high]) => row! { color: Vec3(low), high: Vec3(high) },
            Look::Wrapped([low, high], times) => row! { color: Vec3(low), high: Vec3(high), times: Float(times) },
            Look::Rainbow => Row::new(),
            Look::Ramp(picture) => row! { which: Uint(picture as u32) },
            Look::Marble(picture, axis, part) => {
                row! { which: Uint(picture as u32), axis: Vec3(axis), times: Float(part) }
            }
        };
        let all = row! {
            frequency: Float(self.frequency),
            octaves: Uint(self.octaves),
            seed: Uint(self.seed),
            piece: Float(self.piece()),
        };
        [own, all].concat()
    }
}
