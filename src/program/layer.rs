//! The layers of an image, except its color.

use crate::scene::Scene;

/// A quantity that an image stores in addition to color.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Layer {
    /// The length of the path from the camera to the surface, in scene units.
    Depth,
    /// The number of segments along the path, including a fraction.
    Segments,
    /// The position at which the ray ended.
    Position,
    /// The normal of the surface.
    Normal,
    /// The index of the object that was hit; −1 for none.
    Object,
    /// The termination status of the ray.
    Status,
    /// The number of integration steps.
    Steps,
    /// The redshift factor g: the observed frequency divided by the emitted frequency.
    Redshift,
    /// The number of rays that the pixel took.
    Samples,
    /// The standard error of the pixel's mean luminance.
    StandardError,
    /// The sums of the pixel's samples: red, green and blue.
    Accumulated,
    /// The sum of the squared deviations of the samples' luminance from its mean.
    LuminanceM2,
    /// The luminance of the light from the ray's first, second and third crossing of a translucent surface.
    ImageOrder,
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
    /// Returns why images of a scene cannot have this layer, if they cannot.
    #[must_use]
    pub fn refused_by(self, scene: &Scene) -> Option<&'static str> {
        let (by_paths, adapts) = (scene.rays.path_tracing.is_some(), scene.image.adaptive.is_some());
        match self {
            Self::StandardError if !by_paths && !adapts => Some(
                "the layer `standard_error` requires random samples: set lighting = \"path-tracing\" or image.adaptive",
            ),
            Self::Accumulated | Self::LuminanceM2 if !by_paths || adapts => Some(
                "the layers `accumulated` and `luminance_m2` require lighting = \"path-tracing\" without image.adaptive",
            ),
            Self::Redshift if !scene.has_frequencies() => Some(
                "the layer `redshift` requires camera.observer and a stationary spacetime, and cannot be combined with \
                 lighting = \"path-tracing\"",
            ),
            Self::ImageOrder if !scene.has_orders() => Some(
                "the layer `image_order` requires surfaces with `opacity` below 1, and cannot be combined with \
                 transparent objects, ray splitters, image.adaptive or rays.max_splits = \"stochastic\"",
            ),
            _ => None,
        }
    }

    /// Returns the type of the layer's values.
    #[must_use]
    pub fn kind(self) -> LayerKind {
        match self {
            Self::Depth | Self::Segments | Self::Object | Self::StandardError | Self::Redshift | Self::LuminanceM2 => {
                LayerKind::Scalar
            }
            Self::Position | Self::Normal | Self::Way | Self::Accumulated | Self::ImageOrder => LayerKind::Vector,
            Self::Status | Self::Steps | Self::Samples => LayerKind::Id,
        }
    }

    /// Every layer that files can store.
    pub const ALL: [Self; 13] = [
        Self::Depth,
        Self::Segments,
        Self::Position,
        Self::Normal,
        Self::Object,
        Self::Status,
        Self::Steps,
        Self::Redshift,
        Self::Samples,
        Self::StandardError,
        Self::Accumulated,
        Self::LuminanceM2,
        Self::ImageOrder,
    ];

    /// Returns `true` if the layer describes a pixel's first ray, stored when it is shaded. Other layers describe all rays of a pixel.
    #[must_use]
    pub fn is_of_a_ray(self) -> bool {
        !matches!(self, Self::Samples | Self::StandardError | Self::Accumulated | Self::LuminanceM2 | Self::ImageOrder)
    }

    /// Returns the name. For the layer of a ray, `keep_NAME` is the function
    /// in `shaders/picture/layers.wgsl`, and `layer_NAME` the stored value.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Segments => "segments",
            Self::Position => "position",
            Self::Normal => "normal",
            Self::Object => "object",
            Self::Status => "status",
            Self::Steps => "steps",
            Self::Redshift => "redshift",
            Self::Samples => "samples",
            Self::StandardError => "standard_error",
            Self::Accumulated => "accumulated",
            Self::LuminanceM2 => "luminance_m2",
            Self::ImageOrder => "image_order",
            Self::Way => "way",
        }
    }

    /// Returns a short description.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Depth => "Length of the path from the camera to the surface, in scene units; 1e10 if it hit nothing",
            Self::Segments => "Segments along the path, including a fraction",
            Self::Position => "Position at which the ray ended",
            Self::Normal => "Surface normal",
            Self::Object => "Index of the object that was hit, as in `objects[7]`; -1 for none",
            Self::Status => "Termination status of the ray",
            Self::Steps => "Integration steps",
            Self::Redshift => "Redshift factor g: observed frequency divided by emitted frequency",
            Self::Samples => "Rays traced for the pixel",
            Self::StandardError => {
                "Standard error of the pixel's mean luminance, with path tracing or adaptive sampling"
            }
            Self::Accumulated => "Sums of the samples of a path-traced image, from which --continue resumes",
            Self::LuminanceM2 => "Sum of the squared deviations of the samples' luminance from its mean, likewise",
            Self::ImageOrder => {
                "Luminance of the light from the first, second and third crossing of a translucent surface"
            }
            Self::Way => "Direction of the ray at its end",
        }
    }
}
