//! What a render did, summed over all rays on the device.

use std::fmt;
use std::sync::LazyLock;
use std::time::Duration;

use super::Noise;
use super::records::Row;
use crate::program::constant;

/// How a ray ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Status {
    /// Still under way.
    Alive,
    /// Met an object.
    Hit,
    /// Left the bounding sphere outwards.
    Escaped,
    /// Fell into a hole or a source.
    Captured,
    /// Reached `rays.max_parameter`.
    Ended,
    /// Used `rays.max_segments`.
    Exhausted,
    /// The step fell under what moves the ray.
    Stalled,
    /// Not finite any more.
    Failed,
    /// Would have split once more than `rays.max_splits` allows, or weighs nothing any more.
    Cut,
    /// Not a ray: the picture has none there, as outside a fisheye's disk.
    Outside,
}

impl Status {
    /// Every status but those of rays under way.
    pub const ENDS: [Self; 9] = [
        Self::Hit,
        Self::Escaped,
        Self::Captured,
        Self::Ended,
        Self::Exhausted,
        Self::Stalled,
        Self::Failed,
        Self::Cut,
        Self::Outside,
    ];

    /// The status of a code of `shaders/segment/ray.wgsl`.
    #[must_use]
    pub fn from_code(code: u32) -> Self {
        // Read from the WGSL once: a trace asks for every ray.
        static CODES: LazyLock<Vec<(u32, Status)>> = LazyLock::new(|| {
            let missed = (constant("segment/ray", "MISSED") as u32, Status::Escaped);
            Status::ENDS.into_iter().map(|status| (status.code(), status)).chain([missed]).collect()
        });
        CODES.iter().find(|(known, _)| *known == code).map_or(Self::Alive, |(_, status)| *status)
    }

    /// Its code in `shaders/segment/ray.wgsl`, which outputs carry too.
    #[must_use]
    pub fn code(self) -> u32 {
        constant("segment/ray", &self.name().to_uppercase()) as u32
    }

    /// Its name in outputs.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Alive => "alive",
            Self::Hit => "hit",
            Self::Escaped => "escaped",
            Self::Captured => "captured",
            Self::Ended => "ended",
            Self::Exhausted => "exhausted",
            Self::Stalled => "stalled",
            Self::Failed => "failed",
            Self::Cut => "cut",
            Self::Outside => "outside",
        }
    }
}

/// What adaptive sampling came to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adaptive {
    /// Pixels of the window.
    pub pixels: u64,
    /// Samples that they took together, with the rays through their corners.
    pub samples: u64,
    /// Those that took all the samples they may, and whose mean is not as good as it should be.
    pub capped: u64,
    /// Samples of its own that a pixel may take.
    pub most: u32,
    /// The standard error below which a mean is good enough, in what a screen shows.
    pub tolerance: f64,
}

impl Adaptive {
    /// Samples of a pixel on average.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.samples as f64 / self.pixels as f64
    }
}

impl fmt::Display for Adaptive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels, capped, most, tolerance, .. } = self;
        write!(f, "{:.2} samples a pixel, ", self.mean())?;
        if *capped == 0 {
            return write!(f, "all pixels within {tolerance}");
        }
        let share = 100.0 * *capped as f64 / *pixels as f64;
        write!(f, "{capped} pixels ({share:.2} %) not within {tolerance} after {most}")
    }
}

/// Sums over all rays.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Totals {
    /// Rays set up, with those samples that have none.
    pub rays: u64,
    /// Accepted integration steps.
    pub steps: u64,
    /// Rejected tries.
    pub rejected: u64,
    /// Segments tested.
    pub segments: u64,
    /// Rays by how they ended.
    pub by_status: Vec<(Status, u64)>,
    /// Places on surfaces that no path from a light leads to, light by light, where that is looked for.
    pub unlit: u64,
    /// Pieces of light's ways that a grid had no room for.
    pub lost: u64,
    /// Time on the device by stage (setup, advance, intersect, scatter, shade; advancing includes the two after it unless they are
    /// timed apart, and all rounds of a sample after its first); none without timestamp queries.
    pub device: Option<[Duration; 5]>,
    /// Time from start to end.
    pub wall: Duration,
    /// What adaptive sampling came to, where the scene asks for it.
    pub adaptive: Option<Adaptive>,
    /// Stretches of paths whose filter could not be had to its tolerance, or was none.
    pub unfiltered: u64,
    /// Segments that need more loop iterations than the device runs in one pass; their rays failed.
    pub overrun: u64,
    /// How noisy the picture is, if it is made of random paths.
    pub noise: Option<Noise>,
    /// What samples that were too bright have lost, where the scene limits them.
    pub clamped: Option<Clamped>,
}

/// What samples that were too bright have lost.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Clamped {
    /// How many there were.
    pub samples: u64,
    /// Radiance that they lost, all colours together, summed over all samples of the picture.
    pub lost: f64,
    /// Radiance that is left, of all samples.
    pub left: f64,
}

impl Clamped {
    /// The part of all light that they lost.
    #[must_use]
    pub fn share(&self) -> f64 {
        let all = self.lost + self.left;
        if all > 0.0 { self.lost / all } else { 0.0 }
    }
}

impl fmt::Display for Clamped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} samples clamped, which took {:.2} % of the light", self.samples, 100.0 * self.share())
    }
}

/// What a tally counted of a status code, by its name in WGSL.
fn counted(tally: &Row, name: &str) -> u64 {
    tally.uint_at("statuses", constant("segment/ray", name) as usize).into()
}

impl Totals {
    /// Time of the passes that advance and intersect on the device, or the whole time where a device does not say.
    #[must_use]
    pub fn advance(&self) -> Duration {
        self.device.map_or(self.wall, |[_, advance, intersect, ..]| advance + intersect)
    }

    /// Time of the passes that intersect, where they are timed apart.
    #[must_use]
    pub fn intersect(&self) -> Option<Duration> {
        self.device.map(|[_, _, intersect, ..]| intersect)
    }

    /// Rays that ended so.
    #[must_use]
    pub fn count(&self, status: Status) -> u64 {
        self.by_status.iter().filter(|(s, _)| *s == status).map(|(_, n)| n).sum()
    }

    /// Rays that could not be followed to an end.
    #[must_use]
    pub fn unfollowed(&self) -> u64 {
        [Status::Alive, Status::Exhausted, Status::Stalled, Status::Failed].into_iter().map(|s| self.count(s)).sum()
    }

    /// Rays in a tally whose walks did not end: left alive by passes that ran out, or stopped by the termination.
    pub(super) fn unfinished(tally: &Row) -> u64 {
        counted(tally, "ALIVE") + counted(tally, "UNFINISHED")
    }

    /// Rays in a tally, by the code of how they ended.
    fn ends(tally: &Row) -> impl Iterator<Item = (u32, u64)> {
        let others = ["UNLIT", "LOST", "UNFILTERED", "OVERRUN"].map(|name| constant("segment/ray", name) as u32);
        let codes = 0..constant("state/tally", "STATUSES") as u32;
        codes
            .filter(move |code| !others.contains(code))
            .map(|code| (code, tally.uint_at("statuses", code as usize).into()))
    }

    /// Rays in a tally, however they ended.
    pub(super) fn counted(tally: &Row) -> u64 {
        Self::ends(tally).map(|(_, n)| n).sum()
    }

    /// Adds a tile's tally, the `Tally` of `shaders/state/tally.wgsl`.
    pub(super) fn add_tally(&mut self, tally: &Row) {
        self.steps += tally.wide("steps");
        self.segments += tally.wide("segments");
        self.rejected += tally.wide("rejected");
        self.unlit += counted(tally, "UNLIT");
        self.lost += counted(tally, "LOST");
        self.unfiltered += counted(tally, "UNFILTERED");
        self.overrun += counted(tally, "OVERRUN");
        for (code, n) in Self::ends(tally) {
            self.rays += n;
            let status = Status::from_code(code);
            match self.by_status.iter_mut().find(|(s, _)| *s == status) {
                Some((_, count)) => *count += n,
                None => self.by_status.push((status, n)),
            }
        }
    }
}

impl fmt::Display for Totals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rays, {} steps", self.rays, self.steps)?;
        if self.rejected > 0 {
            write!(f, " ({} rejected)", self.rejected)?;
        }
        write!(f, ", {} segments", self.segments)?;
        if let Some(device) = self.device {
            write!(f, ", {:.3} s on the device", device.iter().sum::<Duration>().as_secs_f64())?;
        }
        write!(f, ", {:.3} s in all;", self.wall.as_secs_f64())?;
        for (status, count) in self.by_status.iter().filter(|(_, count)| *count > 0) {
            write!(f, " {} {count}", status.name())?;
        }
        if self.unlit > 0 {
            write!(f, "; no path from a light for {} places", self.unlit)?;
        }
        if self.unfiltered > 0 {
            write!(f, "; filters not known on {} stretches of paths", self.unfiltered)?;
        }
        if self.overrun > 0 {
            write!(f, "; {} segments of more loop iterations than this device runs in one pass", self.overrun)?;
        }
        if let Some(adaptive) = &self.adaptive {
            write!(f, "; {adaptive}")?;
        }
        if let Some(noise) = &self.noise {
            write!(f, "; {noise}")?;
        }
        if let Some(clamped) = &self.clamped {
            write!(f, "; {clamped}")?;
        }
        Ok(())
    }
}
