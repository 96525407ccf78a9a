//! How radiance becomes a picture file.

/// `[output]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Output {
    /// Stops: radiance is multiplied by 2^exposure for PNG.
    pub exposure: f64,
    /// The curve for PNG.
    pub tonemap: Tonemap,
    /// Bits per channel of a PNG, 8 or 16.
    pub bits: u8,
    /// The radiance of the brightest channel of a sample of random paths, at most: what is more is left out, and counted.
    pub clamp: Option<f64>,
}

/// Tone curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tonemap {
    /// Clip.
    None,
    /// A filmic shoulder.
    Filmic,
}

impl Tonemap {
    /// Each by its name.
    pub const NAMES: &'static [(&'static str, Self)] = &[("none", Self::None), ("filmic", Self::Filmic)];
}
