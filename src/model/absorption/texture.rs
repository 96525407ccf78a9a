//! Noise textures of absorption: noise from 0 to 1 with a color map.

use glam::DVec3;

use crate::model::{Row, row};

/// A transmittance per unit length that follows fractal noise.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// The color map of the noise.
    pub look: NoiseColoring,
    /// The number of lattice cells per unit length; for marble also of waves, each of length 2π.
    pub frequency: f64,
    /// The number of octaves of the noise, 1 to 8.
    pub octaves: u32,
    /// The seed of the noise.
    pub seed: u32,
}

/// The color map of noise from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoiseColoring {
    /// A mix of two colors.
    Mix([DVec3; 2]),
    /// A mix of two colors that repeats as often as this number.
    Wrapped([DVec3; 2], f64),
    /// A spectrum of seven colors.
    Rainbow,
    /// A row of an image from left to right, by the image's index in the scene.
    Ramp(usize),
    /// An image's colors in waves along an axis, displaced by the noise times the number.
    Marble(usize, DVec3, f64),
}

impl Texture {
    /// Returns the name of the density in WGSL.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self.look {
            NoiseColoring::Mix(_) => "mix",
            NoiseColoring::Wrapped(..) => "wrapped",
            NoiseColoring::Rainbow => "rainbow",
            NoiseColoring::Ramp(_) => "ramp",
            NoiseColoring::Marble(..) => "marble",
        }
    }

    /// Returns the size of a cell of the finest octave, which is the initial limit of a path segment.
    fn piece(&self) -> f64 {
        1.0 / (self.frequency * f64::from(1 << (self.octaves - 1)))
    }

    /// Returns the members of `Absorption` that only textures have.
    #[must_use]
    pub fn values(&self) -> Row {
        let own = match self.look {
            NoiseColoring::Mix([low, high]) => row! { color: Vec3(low), high: Vec3(high) },
            NoiseColoring::Wrapped([low, high], times) => {
                row! { color: Vec3(low), high: Vec3(high), times: Float(times) }
            }
            NoiseColoring::Rainbow => Row::new(),
            NoiseColoring::Ramp(picture) => row! { which: Uint(picture as u32) },
            NoiseColoring::Marble(picture, axis, part) => {
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
