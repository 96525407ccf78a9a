//! The purpose of a program: its schedule, and the output that is requested.

use super::{DeviceProfile, Layer};

/// The distribution of a segment's stages over passes. All schedules give the same image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Schedule {
    /// The architecture of W04: one pass for every integration step, one to intersect and one to terminate each segment.
    Paper,
    /// One pass per stage and segment, with N steps inside.
    Segment,
    /// K segments with all their stages in one pass.
    Fused,
    /// A whole path in one pass, from the camera to its color; falls back to `Fused` if a path does not fit into one pass.
    Whole,
}

impl Schedule {
    /// All schedules, from the most passes to the fewest.
    pub const ALL: [Self; 4] = [Self::Paper, Self::Segment, Self::Fused, Self::Whole];

    /// Returns the default way to skip terminated rays; `paper` does it as W04 does.
    #[must_use]
    pub fn masks(self) -> RaySkipping {
        if self == Self::Paper { RaySkipping::Grid } else { RaySkipping::List }
    }

    /// Returns `true` if one pass may compute several segments.
    #[must_use]
    pub fn fuses(self) -> bool {
        matches!(self, Self::Fused | Self::Whole)
    }

    /// Returns the name that users write.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Segment => "segment",
            Self::Fused => "fused",
            Self::Whole => "whole",
        }
    }

    /// Returns a short description.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Paper => "One dispatch per integration step and stage, as in Weiskopf et al. (2004)",
            Self::Segment => "One dispatch per segment and stage",
            Self::Fused => "Wavefront: K segments with all their stages per dispatch",
            Self::Whole => {
                "Megakernel: one dispatch per path, from the camera to the color; falls back to `fused` for paths \
                 that are too long"
            }
        }
    }
}

/// The pixels over which passes process segments. All masks give the same image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RaySkipping {
    /// Every pixel, including pixels whose ray has terminated.
    Off,
    /// Every pixel while any ray is active; terminated rays are skipped in place.
    Grid,
    /// A compact list of the pixels with active rays (active-ray compaction).
    List,
}

/// The passes; each is named after its entry point and file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pass {
    /// Creates the camera's rays.
    Setup,
    /// Computes K segments.
    Advance,
    /// Computes one integration step.
    SingleStep,
    /// Computes the steps of one segment.
    Integrate,
    /// Intersects a segment with the scene.
    Intersect,
    /// Determines which rays have terminated.
    Terminate,
    /// Scatters rays at surfaces that reflect or transmit.
    Scatter,
    /// Computes a whole path.
    Whole,
    /// Computes local illumination.
    Shade,
    /// Computes local illumination from stored ends of paths.
    Reshade,
    /// Stores rays as numbers.
    Record,
    /// Selects the pixels that take more samples.
    Refine,
    /// Measures the bundles of light between rays.
    MeasureBundles,
    /// Lists the cells between rays that have starlight.
    FindStars,
    /// Computes the starlight of these cells.
    LightStars,
    /// Gathers the starlight of each pixel.
    GatherStars,
    /// Computes integration steps only.
    Bare,
    /// Finds paths from lights to positions.
    Shots,
}

impl Pass {
    /// Returns the name of the entry point, which is also the file's name in `shaders/pass/`.
    #[must_use]
    pub fn entry(self) -> &'static str {
        match self {
            Self::Setup => "setup",
            Self::Advance => "advance",
            Self::SingleStep => "single_step",
            Self::Integrate => "integrate",
            Self::Intersect => "intersect",
            Self::Terminate => "terminate",
            Self::Scatter => "scatter",
            Self::Whole => "whole",
            Self::Shade => "shade",
            Self::Reshade => "reshade",
            Self::Record => "record",
            Self::Refine => "refine",
            Self::MeasureBundles => "measure_bundles",
            Self::FindStars => "find_stars",
            Self::LightStars => "light_stars",
            Self::GatherStars => "gather_stars",
            Self::Bare => "bare",
            Self::Shots => "shots",
        }
    }
}

/// The origin of the rays and the use of their results.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mode {
    /// Rays of a camera, for an image.
    Picture,
    /// Given rays, which are recorded.
    Trace,
    /// The camera's rays of chosen pixels, which are recorded.
    Pixels,
    /// Positions and lights; each pair is joined by the paths between them.
    Lit,
    /// Rays from a light, which deposit their light in the voxels along their paths.
    Light,
    /// Rays from a light, which deposit light only after a surface has scattered them.
    Caustics,
    /// The camera's rays, each advanced by a given number of steps, to measure the cost of the steps alone.
    Bare,
}

impl Mode {
    /// Returns `true` if the rays are given one by one, independently of the camera.
    #[must_use]
    pub fn is_given(self) -> bool {
        matches!(self, Self::Trace | Self::Lit | Self::Light | Self::Caustics)
    }

    /// Returns `true` if the rays deposit their light along their paths.
    #[must_use]
    pub fn leaves_light(self) -> bool {
        matches!(self, Self::Light | Self::Caustics)
    }
}

/// The source and the use of the ends of an image's paths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PathEnds {
    /// Paths are followed and shaded.
    Followed,
    /// Paths are followed and shaded, and their ends are stored for later.
    Stored,
    /// The ends that an earlier render has stored are shaded.
    Given,
}

/// Everything except the scene that determines the contents of its program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProgramOptions {
    /// The distribution of stages over passes.
    pub schedule: Schedule,
    /// The way in which terminated rays are skipped.
    pub masks: RaySkipping,
    /// The use of the results, such as an image or a trace.
    pub mode: Mode,
    /// The layers to store, each once.
    pub layers: Vec<Layer>,
    /// The source and the use of the ends of paths.
    pub ends: PathEnds,
    /// The properties of the device.
    pub device: DeviceProfile,
}

impl Default for ProgramOptions {
    fn default() -> Self {
        Self {
            schedule: Schedule::Whole,
            masks: RaySkipping::List,
            mode: Mode::Picture,
            layers: Vec::new(),
            ends: PathEnds::Followed,
            device: DeviceProfile::default(),
        }
    }
}
