//! What a program is for: its schedule, and what it is asked to put out.

use super::{DeviceProfile, Layer};

/// How the stages of a segment are spread over passes. All schedules give the same picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Schedule {
    /// The 2004 architecture: one pass for every integration step, one to intersect and one to terminate each segment.
    Paper,
    /// One pass a stage a segment, N steps inside.
    Segment,
    /// K segments with all their stages in one pass.
    Fused,
    /// A path in one pass, from the camera to its colour; as `Fused` where it does not fit into one.
    Whole,
}

impl Schedule {
    /// All, from the most passes to the fewest.
    pub const ALL: [Self; 4] = [Self::Paper, Self::Segment, Self::Fused, Self::Whole];

    /// How it skips ended rays unless told otherwise: `paper` as in 2004.
    #[must_use]
    pub fn masks(self) -> Masks {
        if self == Self::Paper { Masks::Grid } else { Masks::List }
    }

    /// May a pass be of several segments?
    #[must_use]
    pub fn fuses(self) -> bool {
        matches!(self, Self::Fused | Self::Whole)
    }

    /// As users write it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Segment => "segment",
            Self::Fused => "fused",
            Self::Whole => "whole",
        }
    }

    /// In a few words.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Paper => "One pass for every integration step, as in 2004",
            Self::Segment => "One pass a stage a segment",
            Self::Fused => "K segments with all their stages in one pass",
            Self::Whole => {
                "A path in one pass, from the camera to its colour; as `fused` where it does not fit into one"
            }
        }
    }
}

/// Which pixels the passes over segments run over. All give the same picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Masks {
    /// Every pixel, ended or not.
    Off,
    /// Every pixel as long as one ray lives; what has ended is skipped where it lies.
    Grid,
    /// A dense list of the pixels whose rays live.
    List,
}

/// The passes, each with the name of its entry point and file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pass {
    /// The camera's rays.
    Setup,
    /// K segments.
    Advance,
    /// One step.
    SingleStep,
    /// One segment's steps.
    Integrate,
    /// A segment against the scene.
    Intersect,
    /// Which rays ended.
    Terminate,
    /// Rays that go on from surfaces.
    Scatter,
    /// All of a path.
    Whole,
    /// Local illumination.
    Shade,
    /// Rays as numbers.
    Record,
    /// Which pixels take more samples.
    Refine,
    /// Steps and nothing else.
    Bare,
    /// Paths from lights to places.
    Shots,
}

impl Pass {
    /// The entry point's name, which is also the file's in `shaders/pass/`.
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
            Self::Record => "record",
            Self::Refine => "refine",
            Self::Bare => "bare",
            Self::Shots => "shots",
        }
    }
}

/// Where rays come from and what becomes of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Purpose {
    /// A camera's rays, to be shaded.
    Picture,
    /// Given rays, to be recorded.
    Trace,
    /// The camera's rays of chosen pixels, to be recorded.
    Pixels,
    /// Places and lights, each pair to be joined by the paths between them.
    Lit,
    /// Rays from a light, which leave their light in the voxels on their way.
    Light,
    /// The same, but they leave none before a surface has sent them on.
    Caustics,
    /// The camera's rays, each to be moved by as many steps as it is told, to measure what they cost by themselves.
    Bare,
}

impl Purpose {
    /// Are its rays given one by one, whatever the camera?
    #[must_use]
    pub fn is_given(self) -> bool {
        matches!(self, Self::Trace | Self::Lit | Self::Light | Self::Caustics)
    }

    /// Do its rays leave their light on their way?
    #[must_use]
    pub fn leaves_light(self) -> bool {
        matches!(self, Self::Light | Self::Caustics)
    }
}

/// Everything besides the scene that decides what is in its program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choice {
    /// How passes are cut.
    pub schedule: Schedule,
    /// Are ended rays skipped, and how?
    pub masks: Masks,
    /// Picture or trace.
    pub purpose: Purpose,
    /// Layers to keep, each once.
    pub layers: Vec<Layer>,
    /// What the device is like.
    pub device: DeviceProfile,
}

impl Default for Choice {
    fn default() -> Self {
        Self {
            schedule: Schedule::Whole,
            masks: Masks::List,
            purpose: Purpose::Picture,
            layers: Vec::new(),
            device: DeviceProfile::default(),
        }
    }
}
