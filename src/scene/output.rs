//! The conversion of radiance to an image file.

/// The table `[output]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Output {
    /// The exposure in stops: a PNG shows radiance times 2^exposure.
    pub exposure: f64,
    /// The tone curve of a PNG.
    pub tonemap: Tonemap,
    /// The bits per channel of a PNG, 8 or 16.
    pub bits: u8,
    /// The fraction of light in a PNG that the glare of a lens spreads.
    pub glare: f64,
    /// The largest radiance of the brightest channel of a sample in path tracing; larger values are clamped and counted.
    pub clamp: Option<f64>,
}

/// The tone curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tonemap {
    /// Values are clipped.
    None,
    /// A filmic curve with a shoulder.
    Filmic,
}

impl Tonemap {
    /// The curves by name.
    pub const NAMES: &'static [(&'static str, Self)] = &[("none", Self::None), ("filmic", Self::Filmic)];
}
