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
    /// The radius of the first crossings of translucent surfaces, in scene units; 0 for none, as in the next four.
    CrossingRadius,
    /// The azimuth of these crossings, in radians.
    CrossingAzimuth,
    /// The travel time of light from these crossings, in scene units.
    CrossingTime,
    /// The redshift factor g of light from these crossings.
    CrossingRedshift,
    /// The angle between light and the normal of the surface at these crossings, in radians, in the frame of the surface.
    CrossingAngle,
    /// The intensity at a frequency of the scene, by its index.
    Intensity(u8),
    /// The optical depth of matter at a frequency of the scene, by its index.
    OpticalDepth(u8),
    /// The mean redshift factor g of the light at a frequency of the scene, by its index, weighted by intensity.
    MeanRedshift(u8),
    /// The solid angle of a bundle of light at the camera divided by its solid angle at the sky; negative if the image is mirrored.
    Magnification,
    /// The angular diameters of a pixel's bundle of light at the sky, in radians, and the angle of the larger one from north to east.
    Bundle,
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
    /// A number for each of the first [`CROSSINGS`] crossings.
    Crossings,
    /// A whole number.
    Id,
}

/// Returns a name for each of eight frequencies.
macro_rules! numbered {
    ($name:literal, $k:expr) => { numbered!($name, $k, 0 1 2 3 4 5 6 7) };
    ($name:literal, $k:expr, $($digit:literal)+) => { [$(concat!($name, "_", $digit)),+][usize::from($k % 8)] };
}

/// The largest number of crossings of translucent surfaces that are stored for a ray.
pub const CROSSINGS: usize = 4;

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
            layer if layer.is_of_crossings() && !scene.has_crossings() => Some(
                "the layers of crossings require objects, and cannot be combined with lighting = \"path-tracing\", \
                 image.adaptive or rays.max_splits = \"stochastic\"",
            ),
            Self::Magnification | Self::Bundle if by_paths || adapts => Some(
                "the layers `magnification` and `bundle` cannot be combined with lighting = \"path-tracing\" or image.adaptive",
            ),
            Self::CrossingRedshift if !scene.has_frequencies() => Some(
                "the layer `crossing_redshift` requires camera.observer and a law that defines the frequency of light",
            ),
            Self::CrossingAngle if !scene.law.facts().momentum_parts.is_empty() && !scene.has_frequencies() => Some(
                "the layer `crossing_angle` requires camera.observer under a law that defines the frequency of light",
            ),
            Self::CrossingTime if !scene.law.facts().keeps_time => Some(
                "the layer `crossing_time` requires a law whose τ is a time, such as law.kind = \"kerr-newman\" for any black hole",
            ),
            Self::MeanRedshift(_) if !scene.has_frequencies() => Some(
                "the layers `mean_redshift_K` require camera.observer and a law that defines the frequency of light",
            ),
            Self::Intensity(k) | Self::OpticalDepth(k) | Self::MeanRedshift(k)
                if usize::from(k) >= scene.frequencies() =>
            {
                Some(
                    "the layers `intensity_K`, `optical_depth_K` and `mean_redshift_K` require [radiation] with more than K frequencies",
                )
            }
            _ => None,
        }
    }

    /// Returns `true` if the layer describes light at a frequency of the scene.
    #[must_use]
    pub fn is_of_frequencies(self) -> bool {
        matches!(self, Self::Intensity(_) | Self::OpticalDepth(_) | Self::MeanRedshift(_))
    }

    /// Returns `true` if the layer describes the bundle of light of a pixel.
    #[must_use]
    pub fn is_of_bundles(self) -> bool {
        matches!(self, Self::Magnification | Self::Bundle)
    }

    /// Returns `true` if the layer describes the crossings of translucent surfaces.
    #[must_use]
    pub fn is_of_crossings(self) -> bool {
        self.kind() == LayerKind::Crossings
    }

    /// Returns `true` if the layer describes a path, and does not follow from its end.
    #[must_use]
    pub fn is_of_paths(self) -> bool {
        matches!(self, Self::Depth | Self::Segments | Self::Steps)
            || self.is_of_crossings()
            || self.is_of_frequencies()
            || self.is_of_bundles()
    }

    /// Returns the type of the layer's values.
    #[must_use]
    pub fn kind(self) -> LayerKind {
        match self {
            Self::Depth
            | Self::Segments
            | Self::Object
            | Self::StandardError
            | Self::Redshift
            | Self::LuminanceM2
            | Self::Magnification
            | Self::Intensity(_)
            | Self::OpticalDepth(_)
            | Self::MeanRedshift(_) => LayerKind::Scalar,
            Self::Position | Self::Normal | Self::Way | Self::Accumulated | Self::ImageOrder | Self::Bundle => {
                LayerKind::Vector
            }
            Self::CrossingRadius
            | Self::CrossingAzimuth
            | Self::CrossingTime
            | Self::CrossingRedshift
            | Self::CrossingAngle => LayerKind::Crossings,
            Self::Status | Self::Steps | Self::Samples => LayerKind::Id,
        }
    }

    /// Every layer that files can store.
    pub const ALL: [Self; 44] = [
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
        Self::CrossingRadius,
        Self::CrossingAzimuth,
        Self::CrossingTime,
        Self::CrossingRedshift,
        Self::CrossingAngle,
        Self::Magnification,
        Self::Bundle,
        Self::Intensity(0),
        Self::Intensity(1),
        Self::Intensity(2),
        Self::Intensity(3),
        Self::Intensity(4),
        Self::Intensity(5),
        Self::Intensity(6),
        Self::Intensity(7),
        Self::OpticalDepth(0),
        Self::OpticalDepth(1),
        Self::OpticalDepth(2),
        Self::OpticalDepth(3),
        Self::OpticalDepth(4),
        Self::OpticalDepth(5),
        Self::OpticalDepth(6),
        Self::OpticalDepth(7),
        Self::MeanRedshift(0),
        Self::MeanRedshift(1),
        Self::MeanRedshift(2),
        Self::MeanRedshift(3),
        Self::MeanRedshift(4),
        Self::MeanRedshift(5),
        Self::MeanRedshift(6),
        Self::MeanRedshift(7),
    ];

    /// Returns `true` if the layer describes a pixel's first ray. Other layers describe all rays of a pixel.
    #[must_use]
    pub fn is_of_a_ray(self) -> bool {
        !matches!(self, Self::Samples | Self::StandardError | Self::Accumulated | Self::LuminanceM2 | Self::ImageOrder)
            && !self.is_of_frequencies()
    }

    /// Returns the name. For the layer of a ray's end, `keep_NAME` is the function
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
            Self::CrossingRadius => "crossing_radius",
            Self::CrossingAzimuth => "crossing_azimuth",
            Self::CrossingTime => "crossing_time",
            Self::CrossingRedshift => "crossing_redshift",
            Self::CrossingAngle => "crossing_angle",
            Self::Intensity(k) => numbered!("intensity", k),
            Self::OpticalDepth(k) => numbered!("optical_depth", k),
            Self::MeanRedshift(k) => numbered!("mean_redshift", k),
            Self::Magnification => "magnification",
            Self::Bundle => "bundle",
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
            Self::CrossingRadius => "Radius r of the first four crossings of translucent surfaces; 0 for none",
            Self::CrossingAzimuth => "Azimuth φ of these crossings, in radians",
            Self::CrossingTime => "Travel time t of light from these crossings, in scene units",
            Self::CrossingRedshift => "Redshift factor g of light from these crossings",
            Self::CrossingAngle => "Angle between light and the surface normal at these crossings, in radians",
            Self::Intensity(_) => {
                "Intensity at the frequency of this index: in erg/(cm² s Hz sr) with radiation.emission and [units], otherwise in emission times scene units"
            }
            Self::OpticalDepth(_) => "Optical depth of matter at the frequency of this index",
            Self::MeanRedshift(_) => {
                "Mean redshift factor g of the light at the frequency of this index, weighted by intensity"
            }
            Self::Magnification => {
                "Solid angle of a bundle of light at the camera divided by that at the sky; negative if mirrored, 0 if unknown"
            }
            Self::Bundle => {
                "Angular diameters of a pixel at the sky, in radians, and the angle of the larger one from +y to the east"
            }
            Self::Way => "Direction of the ray at its end",
        }
    }
}
