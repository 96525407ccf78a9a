//! Methods: how a ray is followed, one kind a file.
//!
//! *Practice.* A kind says which WGSL takes its step, what that costs, which controls go with it, which laws it suits, and which
//! settings a chart tries. [`METHODS`] names each kind once; nothing else does. Adding one is a WGSL file in `shaders/method/step/`, a file
//! here and a line of that table.

mod bogacki_shampine;
mod dormand_prince;
mod euler;
mod exact;
mod groeller;
mod leapfrog;
mod planar;
mod rk4;
mod rkn4;
mod separated;
mod snell;

use std::fmt;

use super::control::{self, Control};
use super::same::named;
use super::{Binding, Order, Value};
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::document::{Key, KeyReference, kind_rows};

/// Every method, in the order of the reference and of charts.
pub const METHODS: [&Kind; 11] = [
    &exact::KIND,
    &planar::KIND,
    &separated::KIND,
    &euler::KIND,
    &leapfrog::KIND,
    &rkn4::KIND,
    &rk4::KIND,
    &bogacki_shampine::KIND,
    &dormand_prince::KIND,
    &snell::KIND,
    &groeller::KIND,
];

/// What follows rays without a solver, where all paths have closed forms.
pub const CLOSED_FORMS: Method = Method { kind: &exact::KIND, own: 0.0 };
/// What takes steps that the scene gives, where it names no method.
pub const PLANNED: Method = Method { kind: &rk4::KIND, own: 0.0 };
/// What keeps a tolerance that the scene gives; and what the reference solution is found by.
pub const TOLERANT: Method = Method { kind: &dormand_prince::KIND, own: 0.0 };

/// How a method comes to the next point of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Path {
    /// By closed forms alone.
    Closed,
    /// By an equation of the orbit about the law's only center.
    Orbit,
    /// By steps of the law's differential equation.
    Steps,
}

/// What is known of a method.
pub struct Kind {
    /// As a scene file has it.
    pub name: &'static str,
    /// How it goes on.
    pub path: Path,
    /// The WGSL parts of its step.
    pub parts: &'static [&'static str],
    /// Evaluations of the law's derivative in a step; a pair's first, which is the last of the step before, is not counted.
    pub evaluations: u32,
    /// Its order of convergence; 0 where there is none.
    pub order: u32,
    /// The controls that it goes with.
    pub controls: &'static [&'static control::Kind],
    /// Why it cannot follow rays where these demands are made.
    pub refuses: fn(&Demands) -> Vec<Refusal>,
    /// Do closed forms stand for it where there are some?
    pub closed_forms: bool,
    /// Is its path made of straight steps? Segments are then chords over one step, unless the scene says otherwise.
    pub polygon: bool,
    /// What a step costs besides its evaluations, in evaluations of a simple derivative; none for a method that no chart has shown to
    /// be the fastest somewhere.
    pub step_cost: Option<f64>,
    /// What a chart tries: names, as a chart shows them, and settings from coarse to fine.
    pub sweeps: fn() -> Vec<(&'static str, Vec<Control>)>,
    /// A number that only this method has.
    pub own: Option<&'static OwnNumber>,
}

/// A number that only one method has: its key, and the member of the uniform that it is in WGSL, of the same name.
pub struct OwnNumber {
    /// The key and what it means.
    pub key: Key,
    /// What it is by default.
    pub default: f64,
    /// The uniform.
    pub uniform: &'static str,
}

/// A method with its own number.
#[derive(Clone, Copy, PartialEq)]
pub struct Method {
    /// Its kind.
    pub kind: &'static Kind,
    /// The number that only this kind has; 0 if it has none.
    pub own: f64,
}

/// What a scene demands of the method that follows its rays.
#[derive(Debug, Clone, Copy)]
#[expect(clippy::struct_excessive_bools, reason = "questions that have nothing to do with each other")]
pub struct Demands {
    /// What the law's derivative depends on.
    pub order: Order,
    /// Has the law a single center, so that a ray stays in a plane?
    pub has_plane: bool,
    /// Is it that of a spin, whose orbits separate?
    pub separates: bool,
    /// Is there anything but closed forms to follow?
    pub needs_solver: bool,
    /// Is there an interior that has no closed form?
    pub has_solved_interior: bool,
    /// Is there a medium that may bend light?
    pub has_medium: bool,
    /// Do rays end at a given τ?
    pub ends: bool,
    /// Are segments chords over several steps?
    pub has_chords: bool,
}

/// Why a method does not go with a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Refusal {
    /// The key of `[rays]` that is wrong beside it.
    pub key: &'static str,
    /// What is wrong.
    pub problem: &'static str,
    /// What would be right.
    pub help: &'static str,
}

impl Refusal {
    /// The method itself is wrong.
    pub(super) const fn method(problem: &'static str) -> Self {
        Self { key: "method", problem, help: "use rk4, or leave `method` out" }
    }
}

/// Why no scene's rays can be followed by the equation of an orbit there.
pub(super) fn refuses_orbits(scene: Demands) -> Vec<Refusal> {
    let mut refused = Vec::new();
    if scene.ends {
        let problem = "steps along an orbit are measured by angle and cannot end at a given τ";
        refused.push(Refusal {
            key: "max_parameter",
            problem,
            help: "use dormand-prince, or leave `max_parameter` out",
        });
    }
    if scene.has_chords {
        let help = "use segment = \"arc\", or another method";
        refused.push(Refusal { key: "segment", problem: "a method of orbits has no chords", help });
    }
    refused
}

impl Method {
    /// Of a kind, with the usual number of its own.
    #[must_use]
    pub fn new(kind: &'static Kind) -> Self {
        Self { kind, own: kind.own.map_or(0.0, |own| own.default) }
    }

    /// What its own parts are fed.
    #[must_use]
    pub fn values(&self) -> Option<Binding> {
        let own = self.kind.own?;
        Some(Binding::one(own.uniform, vec![(own.key.key.into(), Value::Float(self.own))]))
    }
}

impl Kind {
    /// Steps of the law's differential equation, one evaluation each, without demands: what methods differ from.
    pub const STEPS: Self = Self {
        name: "",
        path: Path::Steps,
        parts: &[],
        evaluations: 1,
        order: 1,
        controls: &control::PLANNED,
        refuses: |_| Vec::new(),
        closed_forms: false,
        polygon: false,
        step_cost: None,
        sweeps: Vec::new,
        own: None,
    };
}

named!(Kind);

impl fmt::Debug for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.kind.name)
    }
}

/// A name of the scene format: a method by some of its controls, which share a suffix of the name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Named {
    /// The method.
    pub kind: &'static Kind,
    /// What follows the method's name.
    pub suffix: &'static str,
}

impl Named {
    /// A method by its usual control.
    #[must_use]
    pub fn plain(method: Method) -> Self {
        Self { kind: method.kind, suffix: "" }
    }

    /// The controls that it may have by this name.
    fn controls(self) -> Vec<&'static control::Kind> {
        self.kind.controls.iter().copied().filter(|control| control.suffix == self.suffix).collect()
    }

    /// The keys that it reads.
    fn keys(self) -> Vec<Key> {
        let controls = self.controls().into_iter().flat_map(|control| control.keys);
        controls.copied().chain(self.kind.own.map(|own| own.key)).collect()
    }

    /// The method and its control, by the keys of a `[rays]` table.
    pub(crate) fn read(self, table: &TableReader) -> (Method, Control) {
        let own = self.kind.own.map_or(0.0, |own| table.or(own.key.key, own.default, positive));
        (Method { kind: self.kind, own }, control::read(&self.controls(), table))
    }
}

/// Every name that a scene file may give a method.
#[must_use]
pub fn names() -> Vec<(String, Named)> {
    let named = |kind: &'static Kind| {
        let suffixes = kind.controls.chunk_by(|a, b| a.suffix == b.suffix).map(|controls| controls[0].suffix);
        suffixes.map(move |suffix| (format!("{}{suffix}", kind.name), Named { kind, suffix }))
    };
    METHODS.into_iter().flat_map(named).collect()
}

/// A method with its control, as keys and values of the scene format.
#[must_use]
pub fn settings(method: Method, control: Control) -> Vec<(&'static str, String)> {
    let mut all = vec![("method", control::quoted(&format!("{}{}", method.kind.name, control.kind.suffix)))];
    all.extend(control.settings());
    all.extend(method.kind.own.map(|own| (own.key.key, control::written(method.own))));
    all
}

/// The keys of everything that any method or control reads, and of the method itself.
#[must_use]
pub fn setting_keys() -> Vec<&'static str> {
    let read = names().into_iter().flat_map(|(_, named)| named.keys());
    let mut all: Vec<&str> = read.map(|key| key.key).chain(["method"]).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// A method and its setting in words of the scene format.
#[must_use]
pub fn method_words(method: Method, control: Control) -> String {
    control.words(method.kind.name)
}

/// The reference's rows of the keys that methods read.
#[must_use]
pub fn reference() -> Vec<KeyReference> {
    let meaning = "the integrator; auto finds the cheapest at the accuracy. By default exact if no light is bent, \
                   otherwise a method for the given steps or tolerance, otherwise auto";
    let all = names();
    let keys: Vec<Vec<Key>> = all.iter().map(|(_, named)| named.keys()).collect();
    let kinds = all.iter().zip(&keys).map(|((name, _), keys)| (&**name, &**keys));
    let kinds: Vec<(&str, &[Key])> = std::iter::once(("auto", [].as_slice())).chain(kinds).collect();
    kind_rows("rays", ("method", "see there", meaning), &kinds)
}
