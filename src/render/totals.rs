//! Sums the results of a render over all rays on the device.

use std::fmt;
use std::sync::LazyLock;
use std::time::Duration;

use super::records::Row;
use super::{Adaptive, Clamped, FrequencyTotals, Noise, StarImages};
use crate::program::constant;

/// The termination status of a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Status {
    /// The ray is still active.
    Alive,
    /// The ray hit an object.
    Hit,
    /// The ray left the bounding sphere outwards.
    Escaped,
    /// The ray fell into a black hole or a source.
    Captured,
    /// The ray reached `rays.max_parameter`.
    Ended,
    /// The ray used `rays.max_segments`.
    Exhausted,
    /// The step became too small to move the ray.
    Stalled,
    /// The state of the ray is not finite.
    Failed,
    /// The ray would have split more often than `rays.max_splits` allows, or its throughput is 0.
    Cut,
    /// There is no ray, because the image has none at this pixel, for example outside the disk of a fisheye.
    Outside,
}

/// The code of each end, and of a ray that missed everything; read from the WGSL once, because a trace looks up every ray.
static CODES: LazyLock<Vec<(u32, Status)>> = LazyLock::new(|| {
    let code = |status: Status| constant("segment/ray", &status.name().to_uppercase()) as u32;
    let missed = (constant("segment/ray", "MISSED") as u32, Status::Escaped);
    Status::ENDS.into_iter().map(|status| (code(status), status)).chain([missed]).collect()
});

impl Status {
    /// Every status of a terminated ray.
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

    /// Returns the status with a code of `shaders/segment/ray.wgsl`.
    #[must_use]
    pub fn from_code(code: u32) -> Self {
        CODES.iter().find(|(known, _)| *known == code).map_or(Self::Alive, |(_, status)| *status)
    }

    /// Returns the code in `shaders/segment/ray.wgsl`, which output files use too.
    #[must_use]
    pub fn code(self) -> u32 {
        CODES.iter().find(|(_, status)| *status == self).map_or(0, |(code, _)| *code)
    }

    /// Returns the name in output.
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

/// The sums over all rays.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Totals {
    /// The number of rays set up, including samples without a ray.
    pub rays: u64,
    /// The number of accepted integration steps.
    pub steps: u64,
    /// The number of rejected steps.
    pub rejected: u64,
    /// The number of tested segments.
    pub segments: u64,
    /// The number of rays for each termination status.
    pub by_status: Vec<(Status, u64)>,
    /// The number of surface positions to which no path from a light was found, counted for each light that is searched for.
    pub unlit: u64,
    /// The number of pieces of light paths that a grid had no room for.
    pub lost: u64,
    /// The time on the device by stage: setup, advance, intersect, scatter, shade. Advancing includes the two stages after it unless these
    /// are timed separately, and all rounds of a sample after the first. `None` without timestamp queries.
    pub device: Option<[Duration; 5]>,
    /// The time from start to end.
    pub wall: Duration,
    /// The result of adaptive sampling, if the scene requests it.
    pub adaptive: Option<Adaptive>,
    /// The number of path segments on which the light or the absorption of matter did not converge to its tolerance.
    pub unsettled: u64,
    /// The light at each frequency, in images of scenes with `[radiation]`.
    pub radiation: Vec<FrequencyTotals>,
    /// The number of rays through matter that is negative, not a number, or faster than light; they show no light.
    pub undefined: u64,
    /// The number of segments that need more loop iterations than the device runs in one pass; their rays failed.
    pub overrun: u64,
    /// The noise of the image, if it consists of random paths.
    pub noise: Option<Noise>,
    /// The light removed from samples that were too bright, if the scene limits them.
    pub clamped: Option<Clamped>,
    /// The images of stars, if the sky has stars.
    pub stars: Option<StarImages>,
}

/// Returns the count of a status code in a tally, by its name in WGSL.
fn counted(tally: &Row, name: &str) -> u64 {
    tally.uint_at("statuses", constant("segment/ray", name) as usize).into()
}

impl Totals {
    /// Returns the time of the passes that advance and intersect on the device, or the total time if the device has no timestamps.
    #[must_use]
    pub fn advance(&self) -> Duration {
        self.device.map_or(self.wall, |[_, advance, intersect, ..]| advance + intersect)
    }

    /// Returns the time of the passes that intersect, if they are timed separately.
    #[must_use]
    pub fn intersect(&self) -> Option<Duration> {
        self.device.map(|[_, _, intersect, ..]| intersect)
    }

    /// Returns the number of rays with this status.
    #[must_use]
    pub fn count(&self, status: Status) -> u64 {
        self.by_status.iter().filter(|(s, _)| *s == status).map(|(_, n)| n).sum()
    }

    /// Returns the number of rays that could not be followed to an end.
    #[must_use]
    pub fn unfollowed(&self) -> u64 {
        [Status::Alive, Status::Exhausted, Status::Stalled, Status::Failed].into_iter().map(|s| self.count(s)).sum()
    }

    /// Returns the number of rays in a tally that did not end: active after the last pass, or stopped by the termination.
    pub(super) fn unfinished(tally: &Row) -> u64 {
        counted(tally, "ALIVE") + counted(tally, "UNFINISHED")
    }

    /// Returns the numbers of rays in a tally, by the code of their status.
    fn ends(tally: &Row) -> impl Iterator<Item = (u32, u64)> {
        let others =
            ["UNLIT", "LOST", "OVERRUN", "UNDEFINED", "UNSETTLED"].map(|name| constant("segment/ray", name) as u32);
        let codes = 0..constant("state/tally", "STATUSES") as u32;
        codes
            .filter(move |code| !others.contains(code))
            .map(|code| (code, tally.uint_at("statuses", code as usize).into()))
    }

    /// Returns the number of all rays in a tally.
    pub(super) fn counted(tally: &Row) -> u64 {
        Self::ends(tally).map(|(_, n)| n).sum()
    }

    /// Adds the totals of other rays of the same program.
    pub fn add(&mut self, other: &Self) {
        self.rays += other.rays;
        self.steps += other.steps;
        self.rejected += other.rejected;
        self.segments += other.segments;
        self.unlit += other.unlit;
        self.lost += other.lost;
        self.undefined += other.undefined;
        self.unsettled += other.unsettled;
        self.overrun += other.overrun;
        self.radiation.resize(self.radiation.len().max(other.radiation.len()), FrequencyTotals::default());
        self.radiation.iter_mut().zip(&other.radiation).for_each(|(own, other)| own.merge(other));
        self.wall += other.wall;
        let device = |times: [Duration; 5]| self.device.map_or(times, |own| std::array::from_fn(|k| own[k] + times[k]));
        self.device = other.device.map(device);
        for (status, n) in &other.by_status {
            match self.by_status.iter_mut().find(|(own, _)| own == status) {
                Some((_, count)) => *count += n,
                None => self.by_status.push((*status, *n)),
            }
        }
    }

    /// Adds a tile's tally, the `Tally` of `shaders/state/tally.wgsl`.
    pub(super) fn add_tally(&mut self, tally: &Row) {
        self.steps += tally.wide("steps");
        self.segments += tally.wide("segments");
        self.rejected += tally.wide("rejected");
        self.unlit += counted(tally, "UNLIT");
        self.lost += counted(tally, "LOST");
        self.undefined += counted(tally, "UNDEFINED");
        self.unsettled += counted(tally, "UNSETTLED");
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
        write!(f, ", {:.3} s in total;", self.wall.as_secs_f64())?;
        for (status, count) in self.by_status.iter().filter(|(_, count)| *count > 0) {
            write!(f, " {} {count}", status.name())?;
        }
        if self.unlit > 0 {
            write!(f, "; no light path found for {} points", self.unlit)?;
        }
        if self.undefined > 0 {
            write!(f, "; matter not defined on {} rays", self.undefined)?;
        }
        if self.unsettled > 0 {
            write!(f, "; light in matter not converged on {} path segments", self.unsettled)?;
        }
        if self.overrun > 0 {
            write!(f, "; {} segments need more loop iterations than this device runs in one pass", self.overrun)?;
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
        if let Some(stars) = &self.stars {
            write!(f, "; {stars}")?;
        }
        Ok(())
    }
}
