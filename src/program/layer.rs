//! The layers of an image besides its color.

/// A quantity that an image stores besides color.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Layer {
    /// The number of segments along the path, including a fraction.
    Depth,
    /// The position at which the ray ended.
    Position,
    /// The normal of the surface.
    Normal,
    /// The object that was hit, from 1; 0 for none.
    Object,
    /// The termination status of the ray.
    Status,
    /// The number of integration steps.
    Steps,
    /// The redshift factor g: the observed frequency divided by the emitted frequency.
    Shift,
    /// The number of rays that the pixel took.
    Samples,
    /// The standard error of the pixel's mean luminance.
    Error,
    /// The sums of the pixel's samples: red, green and blue.
    Sums,
    /// The sum of the squared deviations of the samples' luminance from its mean.
    Spread,
    /// The luminance of the light from the ray's first, second and third crossing of a translucent surface.
    Orders,
    /// The direction of the ray at its end, with the path length as its
    /// magnitude; used by measurements on images, and not written to files.
    Way,
}

/// The type of a layer's values.
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
    /// Returns the type of the layer's values.
    #[must_use]
    pub fn kind(self) -> LayerKind {
        match self {
            Self::Depth | Self::Error | Self::Shift | Self::Spread => LayerKind::Scalar,
            Self::Position | Self::Normal | Self::Way | Self::Sums | Self::Orders => LayerKind::Vector,
            Self::Object | Self::Status | Self::Steps | Self::Samples => LayerKind::Id,
        }
    }

    /// Every layer that files can store.
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

    /// Returns `true` if the layer describes a pixel's first ray, stored when it is shaded. Other layers describe all rays of a pixel.
    #[must_use]
    pub fn is_of_a_ray(self) -> bool {
        !matches!(self, Self::Samples | Self::Error | Self::Sums | Self::Spread | Self::Orders)
    }

    /// Returns the name. For the layer of a ray, `keep_NAME` is the function
    /// in `shaders/picture/layers.wgsl`, and `layer_NAME` the stored value.
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

    /// Returns a short description.
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
