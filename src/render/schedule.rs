//! Schedules: the same stages, cut into different passes.

use super::renderer::Refines;
use crate::gpu::{OPEN, Slots, WANTED};
use crate::program::{Choice, Masks, Pass, Purpose, Schedule, Work};
use crate::scene::{Scene, Segment};

/// What a pass runs over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dispatch {
    /// Every pixel of the tile.
    Grid,
    /// What still lived before this round of the loop, by indirect dispatch.
    Living,
    /// Every pixel in the first round of a sample, in later ones those that have a path left, by indirect dispatch.
    Open,
}

/// One dispatch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Which pass.
    pub pass: Pass,
    /// Which slots of the state it reads and writes.
    pub slots: Slots,
    /// Over what.
    pub dispatch: Dispatch,
    /// The round of the loop over segments that it belongs to.
    pub round: u64,
    /// Which part of the list of the living it reads.
    pub living: u64,
    /// Does it go on with a walk that was suspended?
    pub again: bool,
    /// Is it of the first segments, which run over the same pixels as the setup?
    pub first: bool,
    /// Integration steps of one ray in it, at most: its weight when the work is split into submissions.
    pub weight: u64,
}

/// Every dispatch of one round of a sample, in order: for paths of up to `max_segments`, K = `segments` of them in a fused pass.
#[must_use]
pub fn steps(scene: &Scene, choice: &Choice, work: &Work, max_segments: u32, segments: u32) -> Vec<Step> {
    let open = choice.lists_open(scene);
    let mut recorded = Recorder { choice, max_segments, open, steps: Vec::new() };
    recorded.push(Pass::Setup, Slots { input: 0, output: 0, start: 0, end: 0, list: [0; 2] }, 0, 1);
    let n = match scene.rays.segment {
        Segment::Chord { steps } => u64::from(steps),
        Segment::Arc { .. } => 1,
    };
    if choice.purpose == Purpose::Bare {
        recorded.push(Pass::Bare, Slots { input: 0, output: 1, start: 0, end: 1, list: [0; 2] }, 0, 1);
        return recorded.steps;
    }
    match choice.schedule {
        Schedule::Fused => recorded.fused(work, segments, n),
        Schedule::Segment => recorded.by_segment(scene, work, n),
        Schedule::Paper => recorded.by_step(scene, work, n, choice.slots(scene)),
    }
    let passes = choice.passes(scene);
    let last = *passes.iter().rfind(|pass| **pass != Pass::Refine).unwrap_or(&Pass::Shade);
    recorded.push(last, Slots { input: 0, output: 0, start: 0, end: 0, list: [OPEN, OPEN + 1] }, 0, n);
    recorded.steps
}

/// What follows a sample of an adaptive picture.
pub(super) fn refining(refines: Refines, masks: Masks) -> Step {
    let dispatch = if refines.listed && masks != Masks::Off { Dispatch::Living } else { Dispatch::Grid };
    let slots = Slots { input: 0, output: 0, start: 0, end: 0, list: refines.lists };
    Step { pass: Pass::Refine, slots, dispatch, round: 0, living: 0, again: false, first: false, weight: 1 }
}

/// Rounds of a sample that write to parts of their own of the lists, so that these are cleared once for all of them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Batch {
    pub rounds: u64,
    /// Parts of the lists of the living that one round needs.
    pub living: u64,
}

impl Batch {
    /// Of a sample that has `rounds` rounds of `steps`.
    pub(super) fn of(steps: &[Step], rounds: u32) -> Self {
        /// A megabyte of them.
        const PARTS: u64 = 4096;
        let living = 2 + steps.iter().map(|step| step.living).max().unwrap_or(0);
        Self { rounds: (PARTS / living).clamp(1, u64::from(rounds)), living }
    }

    /// The parts of its lists that a step reads and writes.
    pub(super) fn parts(&self, step: &Step, round: u32) -> [u64; 2] {
        let (round, open) = (u64::from(round), 2 * self.rounds);
        let first = round % self.rounds * self.living;
        let [read, written] = step.slots.list;
        match [read, written].map(|list| list < OPEN) {
            // Of the lists of those that want more samples there is one part each.
            [false, true] if read >= WANTED => [0, first + step.living + 1],
            [false, false] if read >= WANTED => [0, round % open],
            [true, _] => [first + step.living, first + step.living + 1],
            // What a round leaves open is the next one's work.
            [false, true] => [(round + open - 1) % open, first + step.living + 1],
            [false, false] => [(round + open - 1) % open, round % open],
        }
    }
}

struct Recorder<'a> {
    choice: &'a Choice,
    max_segments: u32,
    open: bool,
    steps: Vec<Step>,
}

impl Recorder<'_> {
    fn push(&mut self, pass: Pass, mut slots: Slots, round: u64, weight: u64) {
        let once = matches!(pass, Pass::Setup | Pass::Shade | Pass::Record | Pass::Bare);
        // What the first segments' termination lists is the first list there is.
        let first = !once && round == 0 && pass != Pass::Scatter;
        let dispatch = match once || first {
            true if self.open => Dispatch::Open,
            false if self.choice.masks != Masks::Off => Dispatch::Living,
            _ => Dispatch::Grid,
        };
        if dispatch == Dispatch::Open {
            slots.list[0] = OPEN;
        }
        self.steps.push(Step { pass, slots, dispatch, round, living: round, again: false, first, weight });
    }

    /// As many rounds as are needed; those that nothing lives to see cost next to nothing.
    fn fused(&mut self, work: &Work, segments: u32, n: u64) {
        /// Rounds for walks that are gone on with, where few are.
        const SPARE: u64 = 4;
        let sure = work.segments_per_pass(segments);
        let rounds = u64::from(self.max_segments.div_ceil(sure)) * work.passes_per_segment;
        let rounds = rounds + if work.resumed { SPARE } else { 0 };
        for round in 0..rounds {
            let input = (round % 2) as usize;
            let slots = Slots { input, output: 1 - input, start: input, end: 1 - input, list: [input, 1 - input] };
            self.push(Pass::Advance, slots, round, u64::from(segments) * n);
        }
    }

    fn by_segment(&mut self, scene: &Scene, work: &Work, n: u64) {
        for round in 0..u64::from(self.max_segments) {
            let start = (round % 2) as usize;
            let slots = Slots { input: start, output: 1 - start, start, end: 1 - start, list: [start, 1 - start] };
            self.push(Pass::Integrate, slots, round, n);
            self.finish_segment(scene, work, slots, round);
        }
    }

    /// Within a segment of many steps two slots ping-pong while a third keeps the segment's start.
    fn by_step(&mut self, scene: &Scene, work: &Work, n: u64, slots: usize) {
        let mut start = 0;
        for round in 0..u64::from(self.max_segments) {
            let list = [(round % 2) as usize, ((round + 1) % 2) as usize];
            let mut at = start;
            for _ in 0..n {
                let next = (0..slots).find(|&slot| slot != at && (slot != start || slots == 2)).unwrap_or(start);
                let moved = Slots { input: at, output: next, start, end: next, list };
                self.push(Pass::SingleStep, moved, round, 1);
                at = next;
            }
            let whole = Slots { input: start, output: at, start, end: at, list };
            self.finish_segment(scene, work, whole, round);
            start = at;
        }
    }

    fn finish_segment(&mut self, scene: &Scene, work: &Work, slots: Slots, round: u64) {
        if !scene.objects.is_empty() {
            for walk in 0..work.passes_per_segment {
                self.push(Pass::Intersect, slots, round, 1);
                if let Some(step) = self.steps.last_mut() {
                    step.again = walk > 0;
                }
            }
        }
        self.push(Pass::Terminate, slots, round, 1);
        if scene.scatters() {
            // What met a surface is where its segment began, what did not is where it ended already.
            let slots = Slots { input: slots.start, output: slots.end, list: [slots.list[1], slots.list[0]], ..slots };
            self.push(Pass::Scatter, slots, round, 1);
            if let Some(step) = self.steps.last_mut() {
                // Those that the termination has just listed.
                step.living = round + 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Analysis, Extent, Purpose};

    fn scene(segment: &str, image: &str) -> Scene {
        let text = format!(
            "[law]\nkind = \"schwarzschild\"\n[rays]\nmax_segments = 6\n{segment}\nbound = {{ radius = 50 }}\n\
             [materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
             [[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\ncenter = [9, 0, 0]\n\
             [image]\n{image}\n"
        );
        Scene::parse(&text, std::path::Path::new("test.toml"), &[]).unwrap()
    }

    fn recorded(schedule: Schedule, segment: &str, image: &str) -> Vec<Step> {
        let scene = scene(segment, image);
        let choice = Choice { schedule, masks: Masks::List, purpose: Purpose::Picture, layers: Vec::new() };
        let work = Work::of(&scene, &Analysis::of(&scene), Extent::default()).unwrap();
        steps(&scene, &choice, &work, scene.rays.max_segments, 4)
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
    fn a_round_reads_what_the_one_before_left_open() {
        // Adaptive pictures list what is open.
        let steps = recorded(Schedule::Fused, "", "adaptive = 0.05");
        let [Some(setup), Some(advance), Some(last)] = [steps.first(), steps.get(1), steps.last()] else {
            panic!("no steps")
        };
        let batch = Batch { rounds: 3, living: 5 };
        for round in 1..20 {
            let list = |step: &Step, round: u32| step.slots.in_round(round).list;
            let ([read, _], [_, written]) = (batch.parts(setup, round), batch.parts(last, round - 1));
            let [started, living] = batch.parts(advance, round);
            assert_eq!((read, list(setup, round)[0]), (written, list(last, round - 1)[1]));
            assert_eq!((read, list(setup, round)[0]), (batch.parts(last, round)[0], list(last, round)[0]));
            // Half of the parts are cleared before a batch, in which these must not lie.
            assert_ne!(round % 3 == 0, read / 3 == u64::from(round) / 3 % 2);
            assert_eq!((read, list(setup, round)[0]), (started, list(advance, round)[0]));
            assert_eq!((living, list(advance, round)[1]), (u64::from(round) % 3 * 5 + 1, 1));
        }
    }

    #[test]
    fn the_first_segments_run_over_what_setup_ran_over() {
        for (image, dispatch) in [("", Dispatch::Grid), ("adaptive = 0.05", Dispatch::Open)] {
            for schedule in [Schedule::Paper, Schedule::Segment, Schedule::Fused] {
                for step in recorded(schedule, "", image) {
                    let once = matches!(step.pass, Pass::Setup | Pass::Shade);
                    assert_eq!(step.first, !once && step.round == 0, "{schedule:?}: {step:?}");
                    assert_eq!(step.dispatch, if once || step.first { dispatch } else { Dispatch::Living }, "{step:?}");
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
