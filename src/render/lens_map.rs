//! Stores the ends of all paths of an image.

use rayon::prelude::*;

/// A value of the end of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EndValue {
    /// The name in files.
    pub channel: &'static str,
    /// Is `true` for an unsigned whole number, and `false` for a float of 32 bits.
    pub is_whole: bool,
}

const fn float(channel: &'static str) -> EndValue {
    EndValue { channel, is_whole: false }
}

const fn whole(channel: &'static str) -> EndValue {
    EndValue { channel, is_whole: true }
}

/// All values of the end of a path, in the order of `shaders/state/ends.wgsl`.
pub const END_VALUES: [EndValue; 24] = [
    whole("id.status"),
    whole("id.primitive"),
    whole("id.shared_end"),
    whole("id.inside"),
    whole("id.branch"),
    float("position.X"),
    float("position.Y"),
    float("position.Z"),
    float("direction.X"),
    float("direction.Y"),
    float("direction.Z"),
    float("time"),
    float("uv.U"),
    float("uv.V"),
    float("across.X"),
    float("across.Y"),
    float("across.Z"),
    float("down.X"),
    float("down.Y"),
    float("down.Z"),
    float("throughput.R"),
    float("throughput.G"),
    float("throughput.B"),
    float("stretch"),
];

/// The ends of the paths of one sample of each pixel; where surfaces split rays, those of one branch.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MapRound {
    /// The number of the sample.
    pub sample: u32,
    /// The number of the branch, in the order in which they are followed.
    pub branch: u32,
    /// The bits of each of the [`END_VALUES`] for every pixel, row by row; empty if all are 0.
    pub planes: Vec<Vec<u32>>,
}

/// The ends of all paths of an image.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct LensMap {
    /// The width and height of the image.
    pub size: [u32; 2],
    /// The rounds, in the order in which their light is added.
    pub rounds: Vec<MapRound>,
}

impl LensMap {
    /// Returns the plane of a value in the first round, by its channel; empty if all values are 0.
    #[must_use]
    pub fn plane(&self, channel: &str) -> &[u32] {
        let at = END_VALUES.iter().position(|value| value.channel == channel);
        at.and_then(|at| self.rounds.first()?.planes.get(at)).map_or(&[], Vec::as_slice)
    }

    /// Returns the planes of a round, which are added in order if they are new.
    pub(super) fn round(&mut self, sample: u32, branch: u32) -> &mut MapRound {
        let pixels = self.size.iter().map(|side| *side as usize).product();
        let at = self.rounds.partition_point(|round| (round.sample, round.branch) < (sample, branch));
        if self.rounds.get(at).is_none_or(|round| (round.sample, round.branch) != (sample, branch)) {
            let planes = vec![vec![0; pixels]; END_VALUES.len()];
            self.rounds.insert(at, MapRound { sample, branch, planes });
        }
        &mut self.rounds[at]
    }

    /// Drops the planes that are 0 everywhere.
    pub(super) fn shorten(&mut self) {
        let planes = self.rounds.par_iter_mut().flat_map(|round| &mut round.planes);
        planes.filter(|plane| plane.iter().all(|bits| *bits == 0)).for_each(|plane| *plane = Vec::new());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::constant;

    #[test]
    fn values_are_where_the_device_has_them() {
        let place = |channel: &str| END_VALUES.iter().position(|value| value.channel == channel).unwrap();
        for (index, channel) in [
            (constant("state/ends", "END_STATUS"), "id.status"),
            (constant("state/ends", "END_PRIMITIVE"), "id.primitive"),
            (constant("state/ends", "END_SHARED"), "id.shared_end"),
            (constant("state/ends", "END_INSIDE"), "id.inside"),
            (constant("state/ends", "END_BRANCH"), "id.branch"),
            (constant("state/ends", "END_X"), "position.X"),
            (constant("state/ends", "END_V"), "direction.X"),
            (constant("state/ends", "END_TAU"), "time"),
            (constant("state/ends", "END_UV"), "uv.U"),
            (constant("state/ends", "END_ACROSS"), "across.X"),
            (constant("state/ends", "END_DOWN"), "down.X"),
            (constant("state/ends", "END_THROUGHPUT"), "throughput.R"),
            (constant("state/ends", "END_STRETCH"), "stretch"),
        ] {
            assert_eq!(index as usize, place(channel), "{channel}");
        }
        assert_eq!(constant("state/ends", "END_VALUES") as usize, END_VALUES.len());
    }
}
