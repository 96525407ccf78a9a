//! The layers of a picture besides its colour.

/// What a picture carries besides colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Layer {
    /// Segments along the path, whole ones and a fraction.
    Depth,
    /// Where the ray ended.
    Position,
    /// The surface's normal.
    Normal,
    /// The object that was hit, from 1; 0 for none.
    Object,
    /// How the ray ended.
    Status,
    /// Integration steps.
    Steps,
    /// The frequency of what the ray saw, over that at its source.
    Shift,
    /// Rays that the pixel took.
    Samples,
    /// The standard error of the pixel's mean luminance.
    Error,
    /// The sums of the pixel's samples, red, green and blue.
    Sums,
    /// The sum of the squared distances of its samples' luminance from their mean.
    Spread,
    /// The luminance of the light from the ray's first, second and third crossing of a translucent surface.
    Orders,
    /// Where the ray was going at its end, as long as its way there: not for files, but for what is measured on a picture.
    Way,
}

/// What a layer is of each pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayerKind {
    /// A number.
    Scalar,
    /// Three numbers.
    Vector,
    /// A whole number.
    Id,
}

impl Layer {
    /// Returns what it is of each pixel.
    #[must_use]
    pub fn kind(self) -> LayerKind {
        match self {
            Self::Depth | Self::Error | Self::Shift | Self::Spread => LayerKind::Scalar,
            Self::Position | Self::Normal | Self::Way | Self::Sums | Self::Orders => LayerKind::Vector,
            Self::Object | Self::Status | Self::Steps | Self::Samples => LayerKind::Id,
        }
    }

    /// Every layer that files hold.
    pub const ALL: [Self; 12] = [
        Self::Depth,
        Self::Position,
        Self::Normal,
        Self::Object,
        Self::Status,
        Self::Steps,
        Self::Shift,
        Self::Samples,
        Self::Error,
        Self::Sums,
        Self::Spread,
        Self::Orders,
    ];

    /// Is it of a pixel's first ray, kept when that is shaded? The others are of all of a pixel's rays.
    #[must_use]
    pub fn is_of_a_ray(self) -> bool {
        !matches!(self, Self::Samples | Self::Error | Self::Sums | Self::Spread | Self::Orders)
    }

    /// Its name. If it is of a ray, `keep_` and this is its function in `shaders/picture/layers.wgsl`, and `layer_` and this what is kept.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Position => "position",
            Self::Normal => "normal",
            Self::Object => "object",
            Self::Status => "status",
            Self::Steps => "steps",
            Self::Shift => "shift",
            Self::Samples => "samples",
            Self::Error => "error",
            Self::Sums => "sums",
            Self::Spread => "spread",
            Self::Orders => "orders",
            Self::Way => "way",
        }
    }

    /// In a few words.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Depth => "Segments along the path, whole ones and a fraction",
            Self::Position => "Where the ray ended",
            Self::Normal => "The surface's normal",
            Self::Object => "The object, from 1; 0 for none",
            Self::Status => "How the ray ended",
            Self::Steps => "Integration steps",
            Self::Shift => "The frequency of the light that a ray saw, over that at its source",
            Self::Samples => "Rays that the pixel took",
            Self::Error => "The standard error of the pixel's mean luminance, with paths or adaptive sampling",
            Self::Sums => "The sums of the samples of a picture of paths, which it is continued from",
            Self::Spread => "How far its samples are apart, for the same",
            Self::Orders => {
                "The luminance of light from a ray's first, second and third crossing of a translucent surface"
            }
            Self::Way => "Where the ray was going at its end",
        }
    }
}
