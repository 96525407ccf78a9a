//! Divides the stages of a render into passes by different schedules.

use super::RenderSettings;
use super::step::{Dispatch, PixelList, Step};
use crate::gpu::Slots;
use crate::program::{DeviceProfile, Features, Mode, Pass, RaySkipping, Schedule, constant};
use crate::scene::{Scene, Segment};

/// The numbers of recorded passes, if a device's loop budget may end a pass before its work is done. Passes without work cost next to
/// nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PassCounts {
    /// The number of `fused` passes for the segments of one pass.
    pub fused: u64,
    /// The number of passes over which the traversal of one segment may be spread.
    pub walk: u64,
}

impl PassCounts {
    /// The factor by which the numbers grow when they were too small.
    const MORE: u64 = 8;
    /// The maximum of each number.
    const MOST: u64 = 1024;

    /// Returns the numbers that suffice for nearly all scenes on any device.
    #[must_use]
    pub fn usual() -> Self {
        Self { fused: 1, walk: 1 }
    }

    /// Returns larger numbers; `walk` only grows if traversals are suspended. Returns `None` if there are enough passes already.
    #[must_use]
    pub fn more(self, device: &DeviceProfile, suspends: bool) -> Option<Self> {
        let walk = if suspends { Self::MORE * self.walk } else { self.walk };
        let more = Self { fused: Self::MORE * self.fused, walk };
        (device.loop_budget.is_some() && more.fused <= Self::MOST).then_some(more)
    }
}

/// Returns every default dispatch of one round of a sample, in order.
#[must_use]
pub fn usual_steps(scene: &Scene, features: &Features) -> Vec<Step> {
    let most = scene.rays.max_segments;
    let segments = fused_segments(RenderSettings::default().segments, features, most);
    steps(scene, features, PassCounts::usual(), most, segments)
}

/// Returns the number of segments of a fused pass, at least `segments`. If a sample has many rounds, most pixels are idle, and a pass costs
/// more than the ended rays that it drops; fewer and longer passes are then faster.
pub(super) fn fused_segments(segments: u32, features: &Features, max_segments: u32) -> u32 {
    const MANY_ROUNDS: u32 = 64;
    segments.saturating_mul(features.rounds / MANY_ROUNDS).min(max_segments).max(segments)
}

/// Returns every dispatch of one round of a sample, in order, for at most `max_segments` segments, K = `segments` of them in a fused pass.
#[must_use]
pub fn steps(scene: &Scene, features: &Features, passes: PassCounts, max_segments: u32, segments: u32) -> Vec<Step> {
    let mut recorded = Recorder { features, max_segments, steps: Vec::new() };
    let n = match scene.rays.segment {
        Segment::Chord { steps } => u64::from(steps),
        Segment::Arc { .. } => 1,
    };
    if features.schedule == Schedule::Whole {
        let whole = recorded.push(Pass::Whole, Slots::only(0), 0, n * u64::from(segments));
        (whole.read, whole.written) = (PixelList::Open(0), PixelList::Open(1));
        return recorded.steps;
    }
    if features.shades_ends() {
        recorded.push(Pass::Reshade, Slots::only(0), 0, 1).dispatch = Dispatch::Grid;
        return recorded.steps;
    }
    recorded.push(Pass::Setup, Slots::only(0), 0, 1);
    match features.mode {
        Mode::Bare => {
            recorded.push(Pass::Bare, Slots::segment(0, 1), 0, 1);
            return recorded.steps;
        }
        Mode::Lit => {
            // Newton steps, the beginning and end of a search, and a test of the path found.
            for _ in 0..constant("surface/shot/newton", "NEWTON_STEPS") as u32 + 3 {
                recorded.push(Pass::Shots, Slots::only(0), 0, 1);
            }
            return recorded.steps;
        }
        Mode::Picture | Mode::Trace | Mode::Pixels | Mode::Light | Mode::Caustics => {}
    }
    match features.schedule {
        Schedule::Fused | Schedule::Whole => recorded.fused(passes, segments, n),
        Schedule::Segment => recorded.by_segment(passes, n),
        Schedule::Paper => recorded.by_step(passes, n),
    }
    let last = if features.is_picture() { Pass::Shade } else { Pass::Record };
    let last = recorded.push(last, Slots::only(0), 0, n);
    (last.read, last.written) = (PixelList::Open(0), PixelList::Open(1));
    recorded.steps
}

struct Recorder<'a> {
    features: &'a Features,
    max_segments: u32,
    steps: Vec<Step>,
}

impl Recorder<'_> {
    /// Adds a step of an iteration over segments, which reads the iteration's list of active rays and writes the next one.
    fn push(&mut self, pass: Pass, slots: Slots, iteration: u64, weight: u64) -> &mut Step {
        let once = matches!(
            pass,
            Pass::Setup | Pass::Whole | Pass::Shade | Pass::Reshade | Pass::Record | Pass::Bare | Pass::Shots
        );
        // The termination of the first segments writes the first list.
        let first = !once && iteration == 0 && pass != Pass::Scatter;
        let dispatch = match once || first {
            true if self.features.lists_open() => Dispatch::ListedLater,
            false if self.features.masks != RaySkipping::Off => Dispatch::PixelListKind,
            _ => Dispatch::Grid,
        };
        let listed_later = dispatch == Dispatch::ListedLater;
        let read = if listed_later { PixelList::Open(0) } else { PixelList::Active(iteration) };
        let written = PixelList::Active(iteration + 1);
        self.steps.push(Step { pass, slots, read, written, dispatch, iteration, again: false, first, weight });
        let last = self.steps.len() - 1;
        &mut self.steps[last]
    }

    /// Adds as many iterations as may be needed; those without active rays cost next to nothing.
    fn fused(&mut self, passes: PassCounts, segments: u32, n: u64) {
        for iteration in 0..u64::from(self.max_segments.div_ceil(segments)) * passes.fused {
            let start = (iteration % 2) as usize;
            self.push(Pass::Advance, Slots::segment(start, 1 - start), iteration, u64::from(segments) * n);
        }
    }

    fn by_segment(&mut self, passes: PassCounts, n: u64) {
        for iteration in 0..u64::from(self.max_segments) {
            let start = (iteration % 2) as usize;
            let slots = Slots::segment(start, 1 - start);
            self.push(Pass::Integrate, slots, iteration, n);
            self.finish_segment(passes, slots, iteration);
        }
    }

    /// Adds single steps: two slots alternate within a segment, and a third keeps the start of the segment.
    fn by_step(&mut self, passes: PassCounts, n: u64) {
        let slots = self.features.slots;
        let mut start = 0;
        for iteration in 0..u64::from(self.max_segments) {
            let mut at = start;
            for _ in 0..n {
                let next = (0..slots).find(|&slot| slot != at && (slot != start || slots == 2)).unwrap_or(start);
                self.push(Pass::SingleStep, Slots::step(start, at, next), iteration, 1);
                at = next;
            }
            self.finish_segment(passes, Slots::segment(start, at), iteration);
            start = at;
        }
    }

    fn finish_segment(&mut self, passes: PassCounts, slots: Slots, iteration: u64) {
        if self.features.has_objects {
            for walk in 0..passes.walk {
                self.push(Pass::Intersect, slots, iteration, 1).again = walk > 0;
            }
        }
        self.push(Pass::Terminate, slots, iteration, 1);
        if self.features.scatters {
            // Scattering runs over the list that the termination has just written; it writes no list.
            self.push(Pass::Scatter, slots, iteration, 1).read = PixelList::Active(iteration + 1);
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::program::{Analysis, ProgramOptions};

    fn scene(segment: &str, image: &str) -> Scene {
        let text = format!(
            "[law]\nkind = \"schwarzschild\"\n[rays]\nmax_segments = 6\n{segment}\nbounding_sphere = {{ radius = 50 }}\n\
             [materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
             [[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\ncenter = [9, 0, 0]\n\
             [image]\n{image}\n"
        );
        Scene::parse(&text, std::path::Path::new("test.toml"), &[]).unwrap()
    }

    pub(in crate::render) fn recorded(schedule: Schedule, segment: &str, image: &str) -> Vec<Step> {
        let scene = scene(segment, image);
        let options = ProgramOptions { schedule, masks: RaySkipping::List, ..ProgramOptions::default() };
        let passes = PassCounts::usual();
        steps(&scene, &Features::of(&scene, &options, &Analysis::of(&scene)), passes, scene.rays.max_segments, 4)
    }

    #[test]
    fn every_pass_reads_what_the_one_before_wrote() {
        for segment in ["", "segment = \"chord\"\nsteps_per_segment = 3", "segment = \"chord\"\nsteps_per_segment = 4"]
        {
            for schedule in [Schedule::Paper, Schedule::Segment, Schedule::Fused] {
                let mut written = 0;
                for step in recorded(schedule, segment, "") {
                    if matches!(step.pass, Pass::SingleStep | Pass::Integrate | Pass::Advance) {
                        assert_eq!(step.slots.input, written, "{schedule:?} {segment}: {step:?}");
                        assert_ne!(step.slots.output, step.slots.input);
                        written = step.slots.output;
                    }
                    if step.pass == Pass::Terminate {
                        assert_eq!(step.slots.end, written);
                        assert_ne!(step.slots.start, written, "a segment's start is still there at its end");
                    }
                }
            }
        }
    }

    #[test]
    fn the_first_segments_run_over_what_setup_ran_over() {
        for (image, dispatch) in [("", Dispatch::Grid), ("adaptive = 0.05", Dispatch::ListedLater)] {
            for schedule in [Schedule::Paper, Schedule::Segment, Schedule::Fused] {
                for step in recorded(schedule, "", image) {
                    let once = matches!(step.pass, Pass::Setup | Pass::Shade);
                    assert_eq!(step.first, !once && step.iteration == 0, "{schedule:?}: {step:?}");
                    assert_eq!(
                        step.dispatch,
                        if once || step.first { dispatch } else { Dispatch::PixelListKind },
                        "{step:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn paper_has_one_pass_a_step() {
        let steps = recorded(Schedule::Paper, "segment = \"chord\"\nsteps_per_segment = 3", "");
        let count = |pass| steps.iter().filter(|step| step.pass == pass).count();
        assert_eq!((count(Pass::SingleStep), count(Pass::Intersect), count(Pass::Terminate)), (18, 6, 6));
    }
}
