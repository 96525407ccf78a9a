//! Reports the progress of long tasks: tasks report it, and a watcher displays it.
//!
//! *Idea.* A task that takes a while opens a [`Stage`] and reports how many of its units are done. A stage that is opened while others are
//! open is nested inside them. There are no callbacks: a report is one store to memory, and a watcher on another thread reads the [`State`]
//! of all open stages whenever it draws. Reports therefore cost next to nothing and do not affect the work.
//!
//! *Practice.* A [`Progress`] is part of the objects that all work of a kind uses: `Files` for reading scenes, `Gpu` for work on a device.
//! The default reports to nobody.

mod estimate;
mod watched;

use std::borrow::Cow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

pub use estimate::Estimate;
pub use watched::Watched;

/// A handle through which work reports its progress, and from which any thread can read it. Clones share the stages.
#[derive(Debug, Clone, Default)]
pub struct Progress(Option<Arc<Mutex<Stages>>>);

/// The stages that are open, outermost first.
#[derive(Debug, Default)]
struct Stages {
    open: Vec<Arc<Open>>,
    opened: u64,
    is_cancelled: bool,
}

/// An open stage.
#[derive(Debug)]
struct Open {
    number: u64,
    name: Cow<'static, str>,
    /// The number of its units; 0 if unknown.
    units: f64,
    /// `true` if units are separate items, such as frames, so that their number is displayed.
    counted: bool,
    /// The number of units of the enclosing stage that it covers.
    span: f64,
    /// The number of units done, as the bits of an `f64`.
    done: AtomicU64,
}

/// A stage of work, open until it is dropped.
#[derive(Debug)]
#[must_use = "a stage ends when it is dropped"]
pub struct Stage(Option<(Progress, Arc<Open>)>);

/// The work in progress at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// The number of the outermost stage with a known number of units; a new number means a new stage.
    pub number: u64,
    /// The names of the open stages, outermost first.
    pub words: String,
    /// The fraction of the outermost stage that is done, from 0 to 1; `None` if no stage has a known number of units.
    pub done: Option<f64>,
}

impl Progress {
    /// Creates a handle whose state can be read.
    #[must_use]
    pub fn watched() -> Self {
        Self(Some(Arc::default()))
    }

    /// Opens a stage whose length is unknown.
    pub fn stage(&self, name: impl Into<Cow<'static, str>>) -> Stage {
        self.open(name.into(), 0.0, false, 0.0)
    }

    /// Opens a stage of `units` units.
    pub fn measured(&self, name: impl Into<Cow<'static, str>>, units: f64) -> Stage {
        self.open(name.into(), units, false, 0.0)
    }

    /// Opens a stage of `count` items, of which the display shows the current one: `frame 3 of 10`.
    pub fn counted(&self, name: impl Into<Cow<'static, str>>, count: usize) -> Stage {
        self.open(name.into(), count as f64, true, 0.0)
    }

    /// Opens a stage of `units` units that makes up `span` units of the enclosing stage.
    pub fn part(&self, name: impl Into<Cow<'static, str>>, units: f64, span: f64) -> Stage {
        self.open(name.into(), units, false, span)
    }

    /// Asks the work to stop soon with an error; only work that checks [`is_cancelled`](Self::is_cancelled) does.
    pub fn cancel(&self) {
        self.set_cancelled(true);
    }

    /// Withdraws [`cancel`](Self::cancel), for further work.
    pub fn resume(&self) {
        self.set_cancelled(false);
    }

    /// Returns `true` if the work should stop.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.stages().is_some_and(|stages| stages.is_cancelled)
    }

    fn set_cancelled(&self, is_cancelled: bool) {
        if let Some(mut stages) = self.stages() {
            stages.is_cancelled = is_cancelled;
        }
    }

    fn open(&self, name: Cow<'static, str>, units: f64, counted: bool, span: f64) -> Stage {
        let Some(mut stages) = self.stages() else { return Stage(None) };
        stages.opened += 1;
        let number = stages.opened;
        let open = Arc::new(Open { number, name, units, counted, span, done: AtomicU64::new(0) });
        stages.open.push(Arc::clone(&open));
        Stage(Some((self.clone(), open)))
    }

    fn stages(&self) -> Option<MutexGuard<'_, Stages>> {
        // No thread leaves the stages in an inconsistent state.
        Some(self.0.as_ref()?.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Returns the work in progress; `None` between stages.
    #[must_use]
    pub fn state(&self) -> Option<State> {
        let stages = self.stages()?;
        let innermost = stages.open.last()?;
        let words: Vec<_> = stages.open.iter().map(|open| open.words()).filter(|words| !words.is_empty()).collect();
        let first = stages.open.iter().position(|open| open.units > 0.0);
        let (mut done, mut unit) = (0.0, 1.0);
        for (depth, open) in stages.open[first.unwrap_or(stages.open.len())..].iter().enumerate() {
            unit *= if depth == 0 { 1.0 } else { open.span };
            if open.units > 0.0 {
                unit /= open.units;
                done += unit * open.done().min(open.units);
            }
        }
        let number = first.map_or(innermost.number, |i| stages.open[i].number);
        Some(State { number, words: words.join(", "), done: first.map(|_| done.clamp(0.0, 1.0)) })
    }
}

impl Open {
    fn done(&self) -> f64 {
        f64::from_bits(self.done.load(Ordering::Relaxed))
    }

    fn words(&self) -> String {
        if !self.counted {
            return self.name.clone().into_owned();
        }
        let current = (self.done().floor() + 1.0).min(self.units);
        format!("{} {current} of {}", self.name, self.units)
    }
}

impl Stage {
    /// Returns a stage that reports to nobody.
    pub fn unwatched() -> Self {
        Self(None)
    }

    /// Reports that `done` units are done.
    pub fn reach(&self, done: f64) {
        if let Some((_, open)) = &self.0 {
            open.done.store(done.to_bits(), Ordering::Relaxed);
        }
    }

    /// Reports that `units` more units are done, from any thread.
    pub fn advance(&self, units: f64) {
        if let Some((_, open)) = &self.0 {
            let more = |bits: u64| Some((f64::from_bits(bits) + units).to_bits());
            // The closure always returns a value.
            let _ = open.done.fetch_update(Ordering::Relaxed, Ordering::Relaxed, more);
        }
    }
}

impl Drop for Stage {
    /// Closes the stage, and marks the units of the enclosing stage that it covers as done.
    fn drop(&mut self) {
        let Some((progress, own)) = self.0.take() else { return };
        let Some(mut stages) = progress.stages() else { return };
        let Some(at) = stages.open.iter().position(|open| open.number == own.number) else { return };
        stages.open.remove(at);
        if let Some(outer) = at.checked_sub(1).map(|i| &stages.open[i]).filter(|_| own.span > 0.0) {
            outer.done.store((outer.done() + own.span).to_bits(), Ordering::Relaxed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(progress: &Progress) -> (String, Option<f64>) {
        progress.state().map(|state| (state.words, state.done)).unwrap_or_default()
    }

    #[test]
    fn stages_nest_by_the_units_that_they_cover() {
        let progress = Progress::watched();
        assert_eq!(progress.state(), None);
        let frames = progress.counted("frame", 4);
        frames.reach(1.0);
        let compiling = progress.counted("compiling", 2);
        compiling.reach(1.0);
        // Compilation is an unknown fraction of a frame.
        assert_eq!(state(&progress), ("frame 2 of 4, compiling 2 of 2".to_owned(), Some(0.25)));
        drop(compiling);
        let rendering = progress.part("rendering", 200.0, 1.0);
        rendering.reach(100.0);
        assert_eq!(state(&progress), ("frame 2 of 4, rendering".to_owned(), Some(0.375)));
        // A stage without a name or a number of units is not visible in the state.
        let inner = progress.stage("");
        inner.reach(7.0);
        assert_eq!(state(&progress), ("frame 2 of 4, rendering".to_owned(), Some(0.375)));
        drop(inner);
        drop(rendering);
        assert_eq!(state(&progress), ("frame 3 of 4".to_owned(), Some(0.5)));
        frames.reach(4.0);
        assert_eq!(state(&progress), ("frame 4 of 4".to_owned(), Some(1.0)));
        drop(frames);
        assert_eq!(progress.state(), None);
    }

    #[test]
    fn the_outermost_stage_of_known_length_gives_the_fraction() {
        let progress = Progress::watched();
        let search = progress.stage("searching");
        let first = progress.state().map(|state| state.number);
        assert_eq!(state(&progress), ("searching".to_owned(), None));
        let pass = progress.counted("pass", 5);
        pass.reach(2.0);
        assert_eq!(state(&progress), ("searching, pass 3 of 5".to_owned(), Some(0.4)));
        assert_ne!(progress.state().map(|state| state.number), first);
        drop((search, pass));
    }

    #[test]
    fn stages_may_end_in_any_order_and_on_any_thread() {
        let progress = Progress::watched();
        let (outer, inner) = (progress.measured("outer", 8.0), progress.stage("inner"));
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| outer.advance(1.0));
            }
        });
        assert_eq!(state(&progress), ("outer, inner".to_owned(), Some(0.5)));
        drop(outer);
        assert_eq!(state(&progress), ("inner".to_owned(), None));
        drop(inner);
        assert_eq!(progress.state(), None);
    }

    #[test]
    fn without_a_watcher_nothing_is_kept() {
        let progress = Progress::default();
        let stage = progress.measured("work", 1.0);
        stage.reach(1.0);
        assert_eq!(progress.state(), None);
    }
}
