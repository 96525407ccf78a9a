//! Step-size controls: how long a step is, one kind a file.
//!
//! *Theory.* Every length here is a τ; η is a fraction of the law's own scale, and no step is longer than η times that scale,
//! whatever chooses it: far from a hole a controller sees flat space, grows, and would jump over it.
//!
//! *Practice.* A kind says which WGSL keeps the contract `control`, what numbers that is fed, what a step costs under it, and
//! over which settings a chart sweeps it. Adding one is a file here, and its name in the list of the methods that go with it.

pub mod curvature;
pub mod doubling;
pub mod embedded;
pub mod exact;
pub mod fixed;
pub mod iterated;
pub mod scaled;

use std::fmt;

use super::Row;
use super::same::named;
use crate::document::Key;
use crate::document::reader::TableReader;
use crate::document::values::positive;

/// The controls whose step is known before it is taken; the first is that of a scene that names none.
pub const PLANNED: [&Kind; 3] = [&scaled::KIND, &fixed::KIND, &curvature::KIND];
/// Those, and under a name of its own step doubling.
pub const PLANNED_OR_DOUBLED: [&Kind; 4] = [PLANNED[0], PLANNED[1], PLANNED[2], &doubling::REJECTING];

/// What is known of a kind of control.
#[allow(clippy::struct_excessive_bools)] // facts, each by itself
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// The keys that it reads.
    pub keys: &'static [Key],
    /// The WGSL parts that keep its contract.
    pub parts: &'static [&'static str],
    /// Does the next step need more of the last than its size: its error, and the derivative at its end?
    pub remembers: bool,
    /// The members of `control` in WGSL.
    pub values: fn(&Control) -> Row,
    /// Evaluations of the law's derivative in a path, by those of a step, and by accepted and rejected steps.
    pub evaluations: fn(step: f64, steps: f64, rejected: f64) -> f64,
    /// What follows a method's name in a scene file where it has this control.
    pub suffix: &'static str,
    /// And where the method is named to people.
    pub remark: &'static str,
    /// The setting as the scene file has it.
    pub setting: fn(&Control) -> f64,
    /// The setting by what the scene file has.
    pub from_file: fn(f64) -> f64,
    /// The usual setting, halved (or its tolerance taken to a tenth) so many times.
    pub usual: fn(&Control, refined: i32) -> Control,
    /// May a setting between two be tried, their geometric mean?
    pub divides: bool,
    /// Is a step tried again when its error is too large?
    pub rejects: bool,
    /// Are steps over the tolerance kept, and counted as rejected?
    pub keeps_errors: bool,
    /// Is the setting a tolerance?
    pub has_tolerance: bool,
    /// Is it chosen by its first key, among the controls of a method?
    pub has_chooser: bool,
    /// Reads it from the keys of a `[rays]` table, if no other control is chosen.
    pub(crate) read: fn(&TableReader) -> Control,
}

impl Kind {
    /// No control at all: what the others differ from.
    pub const EXACT: Self = Self {
        name: "exact",
        keys: &[],
        parts: &[],
        remembers: false,
        values: |_| Row::new(),
        evaluations: |step, steps, _| step * steps,
        suffix: "",
        remark: "",
        setting: |control| control.setting,
        from_file: |written| written,
        usual: |control, _| *control,
        divides: false,
        rejects: false,
        keeps_errors: false,
        has_tolerance: false,
        has_chooser: false,
        read: |_| exact::CONTROL,
    };
}

/// A control at a setting.
#[derive(Clone, Copy, PartialEq)]
pub struct Control {
    /// Its kind.
    pub kind: &'static Kind,
    /// The number that a chart sweeps: a step in τ, an angle in radians, η, or a tolerance.
    pub setting: f64,
    /// η: no step is longer than this times the law's scale; infinite for steps that are none of the law's business.
    pub cap: f64,
    /// Doubling alone: h grows below this relative difference.
    pub grow_below: f64,
}

impl Control {
    /// Of a kind, at a setting and under a cap.
    #[must_use]
    pub const fn new(kind: &'static Kind, setting: f64, cap: f64) -> Self {
        Self { kind, setting, cap, grow_below: 0.0 }
    }

    /// The setting between two of one kind, by the geometric mean; the second, where there is none.
    #[must_use]
    pub fn between(self, other: Self) -> Self {
        if !self.kind.divides || self.kind != other.kind {
            return other;
        }
        let setting = four_digits((self.setting * other.setting).sqrt());
        let cap = if self.kind.has_tolerance { self.cap } else { setting };
        Self { setting, cap, ..self }
    }

    /// The method of this name in words, with what decides its steps.
    #[must_use]
    pub fn words(&self, method: &str) -> String {
        let named = format!("{method}{}{}", self.kind.suffix, self.kind.remark);
        let Some(key) = self.own_key() else { return named };
        let setting = written((self.kind.setting)(self));
        let cap = if key == scaled::SCALED_STEP.key || self.cap.is_infinite() {
            String::new()
        } else {
            format!(", {} {}", scaled::SCALED_STEP.key, written(self.cap))
        };
        format!("{named}, {key} {setting}{cap}")
    }

    /// All that it is, as keys and values of the scene format.
    #[must_use]
    pub fn settings(&self) -> Vec<(&'static str, String)> {
        let Some(own) = self.own_key() else { return Vec::new() };
        let mut all = vec![(own, written((self.kind.setting)(self)))];
        if own != scaled::SCALED_STEP.key && self.cap.is_finite() {
            all.push((scaled::SCALED_STEP.key, written(self.cap)));
        }
        if self.kind.suffix == doubling::REJECTING.suffix {
            all.extend([("doubling", quoted(self.kind.name)), ("grow_below", written(self.grow_below))]);
        }
        all
    }

    /// The key of its setting.
    fn own_key(&self) -> Option<&'static str> {
        let own = if self.kind.has_tolerance { Some(&doubling::TOLERANCE) } else { self.kind.keys.first() };
        own.map(|own| own.key)
    }

    /// The tolerance, if the control has one.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        self.kind.has_tolerance.then_some(self.setting)
    }

    /// The members of `control` in WGSL.
    #[must_use]
    pub fn values(&self) -> Row {
        (self.kind.values)(self)
    }
}

named!(Kind);

impl fmt::Debug for Control {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {:e} (cap {:e})", self.kind.name, self.setting, self.cap)
    }
}

/// From `first` on, each about `factor` of the one before, in numbers that are short to write.
pub(super) fn falling(first: f64, factor: f64, count: i32) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| four_digits(first * factor.powi(k)))
}

/// Rounds a setting to the digits that it is written with.
pub(crate) fn four_digits(x: f64) -> f64 {
    // Printed and read again: what is written is the number itself.
    format!("{x:.3e}").parse().unwrap_or(x)
}

/// A number that reads as itself.
pub(super) fn written(x: f64) -> String {
    if (1e-3..1e4).contains(&x) { x.to_string() } else { format!("{x:e}") }
}

/// A word as TOML has it.
pub(super) fn quoted(word: &str) -> String {
    format!("\"{word}\"")
}

/// Reads which of these controls a `[rays]` table chooses, and its setting; the first, if none is chosen by its own key.
pub(super) fn read(controls: &[&'static Kind], table: &TableReader) -> Control {
    let chosen_by = |kind: &&'static Kind| kind.has_chooser.then(|| kind.keys[0].key);
    let keys: Vec<&'static str> = controls.iter().filter_map(chosen_by).collect();
    let given = table.one_of(&keys);
    let value = given.and_then(|(key, node)| Some((key, table.reader.accept(positive(node))?)));
    let chosen =
        value.and_then(|(key, value)| Some((*controls.iter().find(|kind| chosen_by(kind) == Some(key))?, value)));
    match chosen {
        Some((kind, written)) => Control::new(kind, (kind.from_file)(written), table.or("scaled_step", 0.5, positive)),
        None => (controls[0].read)(table),
    }
}
