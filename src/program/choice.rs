//! What a program is for: its schedule, and what it is asked to put out.

use glam::DVec3;

use super::{DeviceProfile, Layer};
use crate::scene::{Branches, Precision, Scene, Segment, Shadows};

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

impl Choice {
    /// The passes that the schedule has for this scene, in the order in which they first run.
    #[must_use]
    pub fn passes(&self, scene: &Scene) -> Vec<Pass> {
        let mut passes = match (self.purpose, self.schedule) {
            (Purpose::Bare, _) => return vec![Pass::Setup, Pass::Bare],
            (Purpose::Lit, _) => return vec![Pass::Setup, Pass::Shots],
            (_, Schedule::Whole) => vec![Pass::Whole],
            (_, Schedule::Fused) => vec![Pass::Setup, Pass::Advance],
            (_, Schedule::Segment) => vec![Pass::Setup, Pass::Integrate],
            (_, Schedule::Paper) => vec![Pass::Setup, Pass::SingleStep],
        };
        if matches!(self.schedule, Schedule::Segment | Schedule::Paper) {
            passes.extend((!scene.objects.is_empty()).then_some(Pass::Intersect));
            passes.push(Pass::Terminate);
            passes.extend(scene.scatters().then_some(Pass::Scatter));
        }
        passes.extend(match self.purpose {
            _ if self.schedule == Schedule::Whole => None,
            Purpose::Picture => Some(Pass::Shade),
            Purpose::Trace | Purpose::Pixels | Purpose::Lit | Purpose::Light | Purpose::Caustics | Purpose::Bare => {
                Some(Pass::Record)
            }
        });
        if self.adapts(scene) {
            passes.push(Pass::Refine);
        }
        passes
    }

    /// With the schedule that the scene can have: a path is a pass of its own in pictures that follow one path a sample, and whose
    /// state is not to be rounded between segments.
    #[must_use]
    pub fn settled(&self, scene: &Scene) -> Self {
        let pictured = self.purpose == Purpose::Picture && self.rounds(scene) == 1;
        // Shooting has a pass to itself.
        let shot = scene.has_shadows(Shadows::Shooting);
        let whole = pictured && scene.rays.precision != Precision::Half && !shot;
        let schedule = if self.schedule == Schedule::Whole && !whole { Schedule::Fused } else { self.schedule };
        Self { schedule, ..self.clone() }
    }

    /// Rounds of a sample, at most, in each of which every pixel follows one more path of its tree: the leaves of a full one.
    #[must_use]
    pub fn rounds(&self, scene: &Scene) -> u32 {
        match scene.rays.branches {
            Branches::Enumerated(depth) if self.purpose == Purpose::Picture && scene.branches() => 1 << depth,
            _ => 1,
        }
    }

    /// Does light go from surface to surface?
    #[must_use]
    pub fn follows_paths(&self, scene: &Scene) -> bool {
        self.purpose == Purpose::Picture && scene.rays.paths.is_some()
    }

    /// Do media take from the light of its rays?
    #[must_use]
    pub fn filters(&self, scene: &Scene) -> bool {
        (self.purpose == Purpose::Picture || self.purpose.leaves_light()) && scene.filters().next().is_some()
    }

    /// Do media add to it?
    #[must_use]
    pub fn sees_glow(&self, scene: &Scene) -> bool {
        self.purpose == Purpose::Picture && scene.filters().any(|filter| filter.glow != DVec3::ZERO)
    }

    /// Is light as bright as its shift makes it?
    #[must_use]
    pub fn beams(&self, scene: &Scene) -> bool {
        self.purpose == Purpose::Picture && scene.camera.as_ref().is_some_and(|camera| camera.shift)
    }

    /// And are colours taken for those of black bodies?
    #[must_use]
    pub fn shifts_hues(&self, scene: &Scene) -> bool {
        self.beams(scene) && scene.camera.as_ref().is_some_and(|camera| camera.hues)
    }

    /// Is it asked how light has shifted, and is there an answer?
    #[must_use]
    pub fn knows_shift(&self, scene: &Scene) -> bool {
        self.beams(scene) || self.layers.contains(&Layer::Shift) && scene.has_frequencies()
    }

    /// Does its shift have to be followed along each path, for nothing keeps it?
    #[must_use]
    pub fn follows_shift(&self, scene: &Scene) -> bool {
        self.purpose == Purpose::Picture && self.knows_shift(scene) && scene.law.facts().changes_with_time
    }

    /// Is it asked what light is of which crossing, and is there an answer?
    #[must_use]
    pub fn keeps_orders(&self, scene: &Scene) -> bool {
        self.purpose == Purpose::Picture && self.layers.contains(&Layer::Orders) && scene.has_orders()
    }

    /// Do pixels take as many samples as they need?
    #[must_use]
    pub fn adapts(&self, scene: &Scene) -> bool {
        self.purpose == Purpose::Picture && scene.image.adaptive.is_some()
    }

    /// Is it known what pixels see of pictures and patterns?
    #[must_use]
    pub fn keeps_footprints(&self, scene: &Scene) -> bool {
        self.purpose == Purpose::Picture && scene.has_footprints()
    }

    /// Columns and rows that a tile has beyond its pixels: the last ones' corners are those of the next.
    #[must_use]
    pub fn margin(&self, scene: &Scene) -> u32 {
        (self.adapts(scene) || self.keeps_footprints(scene)).into()
    }

    /// Do later rounds and samples run over no more than the pixels that have a path left, or want more samples?
    #[must_use]
    pub fn lists_open(&self, scene: &Scene) -> bool {
        self.masks != Masks::Off && (self.rounds(scene) > 1 || self.adapts(scene))
    }

    /// Slots of the state pair: `paper` keeps a chord's start while two more ping-pong under its steps.
    #[must_use]
    pub fn slots(&self, scene: &Scene) -> usize {
        let many_steps = matches!(scene.rays.segment, Segment::Chord { steps } if steps > 1);
        if self.schedule == Schedule::Paper && many_steps { 3 } else { 2 }
    }

    /// Does the program keep each ray's step counts?
    #[must_use]
    pub fn keeps_counts(&self) -> bool {
        matches!(self.purpose, Purpose::Trace | Purpose::Pixels) || self.layers.contains(&Layer::Steps)
    }
}
