//! The settings of `[rays]`, which define the integration of rays.

use glam::DVec3;

use crate::model::{Control, Law, Method};

/// The table `[rays]`: the integration of rays.
#[derive(Debug, Clone, PartialEq)]
pub struct Rays {
    /// The integration method.
    pub method: Method,
    /// The step-size control.
    pub control: Control,
    /// The task of a calibration, if the scene leaves the method to it; until it has run, the method is RK4.
    pub auto: Option<Auto>,
    /// The part of a path that is tested for hits.
    pub segment: Segment,
    /// The number of segments after which an active ray is exhausted.
    pub max_segments: u32,
    /// The bounding sphere, outside which rays have escaped.
    pub bounding_sphere: Bound,
    /// The τ at which rays end.
    pub max_parameter: Option<f64>,
    /// Is `true` if rays are followed to infinity in closed form outside the bounding sphere.
    pub sky_at_infinity: bool,
    /// The precision of the numbers.
    pub precision: Precision,
    /// Is `true` if closed forms of media replace the method.
    pub closed_forms: bool,
    /// Is `true` if one step crosses a region that contains nothing else. Paths of diagrams are cut into arcs.
    pub leaps: bool,
    /// The treatment of rays that a surface splits.
    pub max_splits: Splitting,
    /// The acceleration structure for the search of objects.
    pub acceleration: Accelerate,
    /// The settings of path tracing; `None` for direct illumination by the scene's lights.
    pub path_tracing: Option<PathTracing>,
    /// The wavelength of light in nanometers, if it is not sampled; only dispersion depends on it.
    pub wavelength: f64,
}

impl Rays {
    /// Requires an accuracy in radians, if the method is chosen for one and the scene does not specify an angle.
    pub fn refine(&mut self, accuracy: f64) {
        if let Some(auto) = self.auto.as_mut().filter(|auto| matches!(auto.accuracy, Accuracy::Pixels(_))) {
            auto.accuracy = Accuracy::Radians(accuracy);
        }
    }
}

/// The table `[path_tracing]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PathTracing {
    /// The largest number of scattering surfaces along a path; unlimited if `None`.
    pub max_depth: Option<u32>,
    /// The number of surfaces after which Russian roulette may end a path.
    pub rr_depth: u32,
    /// Is `true` if next-event estimation sends one more ray from each point to the emitters.
    pub light_sampling: bool,
    /// Is `true` if light is traced from the emitters first, to guide these rays around obstacles of next-event estimation.
    pub guiding: bool,
    /// The seed of the random numbers.
    pub seed: u32,
}

impl Default for PathTracing {
    fn default() -> Self {
        Self { max_depth: None, rr_depth: 4, light_sampling: true, guiding: true, seed: 0 }
    }
}

/// The structure that limits the objects tested per segment. It does not affect the image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Accelerate {
    /// The structure that measurements favor.
    Auto,
    /// A bounding volume hierarchy.
    Hierarchy,
    /// A uniform grid (G95 §4).
    Grid,
    /// No structure: every segment is tested against every object (W04).
    None,
}

/// The rays that continue from a surface that both reflects and transmits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Splitting {
    /// Both rays, exactly, up to this number of splits along a path; further splits are cut.
    Enumerated(u32),
    /// One random ray per sample.
    Random,
}

/// The settings that a calibration chooses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Auto {
    /// The required accuracy.
    pub accuracy: Accuracy,
    /// Is `true` if the calibration also chooses the precision: 64 bits if 32 do not reach the accuracy.
    pub precision: bool,
}

/// The largest error of a ray's direction for 99 of 100 rays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// A fraction of a pixel's angle at the image center.
    Pixels(f64),
    /// An angle in radians.
    Radians(f64),
}

/// The part of a path that is tested for hits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Segment {
    /// A cubic Hermite arc over one accepted step, subdivided into chords within `tolerance` of it.
    Arc {
        /// The tolerance, in scene units.
        tolerance: f64,
    },
    /// A chord over N steps, as in the polygon of W04.
    Chord {
        /// The number N of steps.
        steps: u32,
    },
}

impl Segment {
    /// Returns `true` for the polygon of W04.
    #[must_use]
    pub fn has_chords(self) -> bool {
        matches!(self, Self::Chord { .. })
    }
}

/// The bounding sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// The center.
    pub center: DVec3,
    /// The radius.
    pub radius: f64,
}

impl Bound {
    /// Returns the center and, if the law leads to another side, the center of the sphere there.
    #[must_use]
    pub fn centers(&self, law: Option<&dyn Law>) -> Vec<DVec3> {
        let throat = law.and_then(|law| law.facts().throat);
        let there = throat.map(|throat| self.center + throat.mouths[1] - throat.mouths[0]);
        std::iter::once(self.center).chain(there).collect()
    }
}

/// The precision in which paths are integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Precision {
    /// Integrated in 32 bits and stored between passes in 16, as in W04.
    Half,
    /// 32 bits.
    Single,
    /// 64 bits, if the device supports them.
    Double,
}

impl Precision {
    /// All precisions in ascending order.
    pub const ALL: [Self; 3] = [Self::Half, Self::Single, Self::Double];

    /// Returns the name in a scene file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Half => "f16",
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }

    /// Returns a short description.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Half => "32-bit arithmetic with 16-bit state between passes, as in Weiskopf et al. (2004)",
            Self::Single => "32 bits",
            Self::Double => "64 bits, if the device supports them",
        }
    }
}
