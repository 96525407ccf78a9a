//! Step-size controls, which choose the length of each step; one file per kind.
//!
//! *Theory.* Every length here is a step in τ. η is a fraction of the law's length scale, and no control takes a step longer than η times
//! that scale. Without this cap, a controller far from a black hole sees flat space, grows its step, and jumps over the hole.
//!
//! *Practice.* A kind names the WGSL module that implements the contract `control` and its uniforms, the cost of a step, and the settings
//! that a chart sweeps. To add a kind, add a file here and its name to the lists of the methods that support it.

pub mod curvature;
pub mod doubling;
pub mod embedded;
pub mod exact;
pub mod fixed;
pub mod iterated;
pub mod scaled;

use std::fmt;

use super::Row;
use super::dyn_eq::named;
use crate::document::Key;
use crate::document::reader::TableReader;
use crate::document::values::positive;

/// The controls that know a step before it is taken; the first is the default.
pub const PLANNED: [&ControlKind; 3] = [&scaled::KIND, &fixed::KIND, &curvature::KIND];
/// The planned controls, and step doubling under a separate name.
pub const PLANNED_OR_DOUBLED: [&ControlKind; 4] = [PLANNED[0], PLANNED[1], PLANNED[2], &doubling::REJECTING];

/// The description of a kind of step-size control.
#[allow(clippy::struct_excessive_bools)] // facts, each by itself
pub struct ControlKind {
    /// The name.
    pub name: &'static str,
    /// The keys that the control reads.
    pub keys: &'static [Key],
    /// The WGSL modules that implement the contract `control`.
    pub parts: &'static [&'static str],
    /// Is `true` if the next step depends on the error and the final derivative of the last step, in addition to its size.
    pub remembers: bool,
    /// The members of `control` in WGSL.
    pub values: fn(&Control) -> Row,
    /// The number of derivative evaluations along a path, from the evaluations per step and the accepted and rejected steps.
    pub evaluations: fn(step: f64, steps: f64, rejected: f64) -> f64,
    /// The suffix of a method's name in a scene file with this control.
    pub suffix: &'static str,
    /// The remark after the name of the method in output for people.
    pub remark: &'static str,
    /// The setting in the units of the scene file.
    pub setting: fn(&Control) -> f64,
    /// The setting converted from the units of the scene file.
    pub from_file: fn(f64) -> f64,
    /// The usual setting after `refined` refinements, each of which halves a step or divides a tolerance by ten.
    pub usual: fn(&Control, refined: i32) -> Control,
    /// Is `true` if the geometric mean of two settings is a useful setting.
    pub divides: bool,
    /// Is `true` if a step with too large an error is repeated.
    pub rejects: bool,
    /// Is `true` if steps over the tolerance are accepted, but counted as rejected.
    pub keeps_errors: bool,
    /// Is `true` if the setting is a tolerance.
    pub has_tolerance: bool,
    /// Is `true` if the presence of the first key selects this control of a method.
    pub has_chooser: bool,
    /// Reads the control from the keys of a `[rays]` table, if no other control is selected.
    pub(crate) read: fn(&TableReader) -> Control,
}

impl ControlKind {
    /// The description of no control, which supplies the defaults of the other kinds.
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

/// A step-size control with its setting.
#[derive(Clone, Copy, PartialEq)]
pub struct Control {
    /// The kind of control.
    pub kind: &'static ControlKind,
    /// The number that a chart sweeps: a step in τ, an angle in radians, η, or a tolerance.
    pub setting: f64,
    /// η, the largest step in units of the law's length scale; infinite if the scale does not limit steps.
    pub cap: f64,
    /// For step doubling only: the relative difference below which h grows.
    pub grow_below: f64,
}

impl Control {
    /// Creates a control from its kind, setting and cap.
    #[must_use]
    pub const fn new(kind: &'static ControlKind, setting: f64, cap: f64) -> Self {
        Self { kind, setting, cap, grow_below: 0.0 }
    }

    /// Returns the control with the geometric mean of two settings of one kind, or the second control if there is no such setting.
    #[must_use]
    pub fn between(self, other: Self) -> Self {
        if !self.kind.divides || self.kind != other.kind {
            return other;
        }
        let setting = four_digits((self.setting * other.setting).sqrt());
        let cap = if self.kind.has_tolerance { self.cap } else { setting };
        Self { setting, cap, ..self }
    }

    /// Returns a description of the method with this name, including the setting that determines its steps.
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

    /// Returns all settings of the control as keys and values of the scene format.
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

    /// Returns the key of the setting.
    fn own_key(&self) -> Option<&'static str> {
        let own = if self.kind.has_tolerance { Some(&doubling::TOLERANCE) } else { self.kind.keys.first() };
        own.map(|own| own.key)
    }

    /// Returns the tolerance, if the control has one.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        self.kind.has_tolerance.then_some(self.setting)
    }

    /// Returns the members of `control` in WGSL.
    #[must_use]
    pub fn values(&self) -> Row {
        (self.kind.values)(self)
    }
}

named!(ControlKind);

impl fmt::Debug for Control {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {:e} (cap {:e})", self.kind.name, self.setting, self.cap)
    }
}

/// Returns `count` settings from `first` downwards, each about `factor` times the one before and short to write.
pub(super) fn falling(first: f64, factor: f64, count: i32) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| four_digits(first * factor.powi(k)))
}

/// Rounds a setting to the four digits that are printed.
pub(crate) fn four_digits(x: f64) -> f64 {
    // Printing and parsing again makes the printed digits the exact value.
    format!("{x:.3e}").parse().unwrap_or(x)
}

/// Formats a number so that parsing returns the identical value.
pub(super) fn written(x: f64) -> String {
    if (1e-3..1e4).contains(&x) { x.to_string() } else { format!("{x:e}") }
}

/// Returns a word in the quotes of TOML.
pub(super) fn quoted(word: &str) -> String {
    format!("\"{word}\"")
}

/// Reads the control that a `[rays]` table selects, with its setting; defaults to the first if no key selects another.
pub(super) fn read(controls: &[&'static ControlKind], table: &TableReader) -> Control {
    let chosen_by = |kind: &&'static ControlKind| kind.has_chooser.then(|| kind.keys[0].key);
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
