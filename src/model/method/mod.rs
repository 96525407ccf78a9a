//! Methods, which integrate the paths of rays; one file per kind.
//!
//! *Practice.* A kind specifies the WGSL module of its step, its cost, its controls, the laws that it supports, and the settings that a
//! chart sweeps. [`METHODS`] is the only list of kinds. To add a kind, add a WGSL file in `shaders/method/step/`, a file here and a line of
//! that table.

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
use super::dyn_eq::named;
use super::{Binding, Order, Value};
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::document::{Key, KeyReference, kind_rows};

/// The list of all methods, in the order of the reference and of charts.
pub const METHODS: [&MethodKind; 11] = [
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

/// The method without a solver, if all paths have closed forms.
pub const CLOSED_FORMS: Method = Method { kind: &exact::KIND, own: 0.0 };
/// The default method for steps that the scene specifies.
pub const PLANNED: Method = Method { kind: &rk4::KIND, own: 0.0 };
/// The default method for a tolerance that the scene specifies, which also computes reference solutions.
pub const TOLERANT: Method = Method { kind: &dormand_prince::KIND, own: 0.0 };

/// The way in which a method computes the next point of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Path {
    /// Closed forms alone.
    Closed,
    /// An equation of the orbit around the law's only center.
    Orbit,
    /// Steps of the law's differential equation.
    Steps,
}

/// The description of a method.
pub struct MethodKind {
    /// The name in a scene file.
    pub name: &'static str,
    /// The way in which it computes the next point.
    pub path: Path,
    /// The WGSL modules of its step.
    pub parts: &'static [&'static str],
    /// The number of derivative evaluations per step, without the first one of an FSAL pair, which the step before computes.
    pub evaluations: u32,
    /// The order of convergence; 0 if there is none.
    pub order: u32,
    /// The controls that the method supports.
    pub controls: &'static [&'static control::ControlKind],
    /// Returns why the method cannot meet these demands.
    pub refuses: fn(&Demands) -> Vec<Unsupported>,
    /// Is `true` if closed forms replace the method where they exist.
    pub closed_forms: bool,
    /// Is `true` if the path consists of straight steps. Segments are then chords over one step, unless the scene specifies otherwise.
    pub polygon: bool,
    /// The cost of a step in addition to its evaluations, in evaluations of a simple derivative; `None` for a method that is the fastest in
    /// no chart.
    pub step_cost: Option<f64>,
    /// Returns the names and settings of a chart, from coarse to fine.
    pub sweeps: fn() -> Vec<(&'static str, Vec<Control>)>,
    /// The parameter that only this method has.
    pub own: Option<&'static MethodParameter>,
}

/// The parameter of one method, by its key and by the uniform in which a WGSL member has the name of the key.
pub struct MethodParameter {
    /// The key and its meaning.
    pub key: Key,
    /// The default.
    pub default: f64,
    /// The uniform.
    pub uniform: &'static str,
}

/// A method with its parameter.
#[derive(Clone, Copy, PartialEq)]
pub struct Method {
    /// The kind of method.
    pub kind: &'static MethodKind,
    /// The parameter that only this kind has; 0 if it has none.
    pub own: f64,
}

/// The demands of a scene on the method that follows its rays.
#[derive(Debug, Clone, Copy)]
#[expect(clippy::struct_excessive_bools, reason = "questions that have nothing to do with each other")]
pub struct Demands {
    /// The variables on which the law's derivative depends.
    pub order: Order,
    /// Is `true` if the law has a single center, so that a ray stays in a plane.
    pub has_plane: bool,
    /// Is `true` if the center is a rotating black hole, whose orbits separate.
    pub separates: bool,
    /// Is `true` if not all paths have closed forms.
    pub needs_solver: bool,
    /// Is `true` if there is an interior without a closed form.
    pub has_solved_interior: bool,
    /// Is `true` if there is a medium that may bend light.
    pub has_medium: bool,
    /// Is `true` if rays end at a given τ.
    pub ends: bool,
    /// Is `true` if segments are chords over several steps.
    pub has_chords: bool,
}

/// A reason why a method does not support a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unsupported {
    /// The key of `[rays]` that conflicts with the method.
    pub key: &'static str,
    /// The problem.
    pub problem: &'static str,
    /// The remedy.
    pub help: &'static str,
}

impl Unsupported {
    /// Creates a refusal of the method itself.
    pub(super) const fn method(problem: &'static str) -> Self {
        Self { key: "method", problem, help: "use rk4, or remove `method`" }
    }
}

/// Returns why the orbit equation cannot follow the rays of a scene.
pub(super) fn refuses_orbits(scene: Demands) -> Vec<Unsupported> {
    let mut refused = Vec::new();
    if scene.ends {
        let problem = "steps along an orbit are measured by angle and cannot end at a given τ";
        refused.push(Unsupported {
            key: "max_parameter",
            problem,
            help: "use dormand-prince, or remove `max_parameter`",
        });
    }
    if scene.has_chords {
        let help = "use segment = \"arc\", or another method";
        refused.push(Unsupported {
            key: "segment",
            problem: "a method that integrates orbits does not support chords",
            help,
        });
    }
    refused
}

impl Method {
    /// Creates a method of a kind with the default parameter.
    #[must_use]
    pub fn new(kind: &'static MethodKind) -> Self {
        Self { kind, own: kind.own.map_or(0.0, |own| own.default) }
    }

    /// Returns the values of its WGSL modules.
    #[must_use]
    pub fn values(&self) -> Option<Binding> {
        let own = self.kind.own?;
        Some(Binding::one(own.uniform, vec![(own.key.key.into(), Value::Float(self.own))]))
    }
}

impl MethodKind {
    /// The description of a method of one evaluation per step without demands, which supplies the defaults of the other kinds.
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

named!(MethodKind);

impl fmt::Debug for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.kind.name)
    }
}

/// A name in the scene format: a method with the controls that share a suffix of the name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NamedMethod {
    /// The method.
    pub kind: &'static MethodKind,
    /// The suffix of the method's name.
    pub suffix: &'static str,
}

impl NamedMethod {
    /// Creates the name of a method with its usual control.
    #[must_use]
    pub fn plain(method: Method) -> Self {
        Self { kind: method.kind, suffix: "" }
    }

    /// Returns the controls that this name may have.
    fn controls(self) -> Vec<&'static control::ControlKind> {
        self.kind.controls.iter().copied().filter(|control| control.suffix == self.suffix).collect()
    }

    /// Returns the keys that the method reads.
    fn keys(self) -> Vec<Key> {
        let controls = self.controls().into_iter().flat_map(|control| control.keys);
        controls.copied().chain(self.kind.own.map(|own| own.key)).collect()
    }

    /// Reads the method and its control from the keys of a `[rays]` table.
    pub(crate) fn read(self, table: &TableReader) -> (Method, Control) {
        let own = self.kind.own.map_or(0.0, |own| table.or(own.key.key, own.default, positive));
        (Method { kind: self.kind, own }, control::read(&self.controls(), table))
    }
}

/// Returns all names that a scene file may specify for a method.
#[must_use]
pub fn names() -> Vec<(String, NamedMethod)> {
    let named = |kind: &'static MethodKind| {
        let suffixes = kind.controls.chunk_by(|a, b| a.suffix == b.suffix).map(|controls| controls[0].suffix);
        suffixes.map(move |suffix| (format!("{}{suffix}", kind.name), NamedMethod { kind, suffix }))
    };
    METHODS.into_iter().flat_map(named).collect()
}

/// Returns a method with its control as keys and values of the scene format.
#[must_use]
pub fn settings(method: Method, control: Control) -> Vec<(&'static str, String)> {
    let mut all = vec![("method", control::quoted(&format!("{}{}", method.kind.name, control.kind.suffix)))];
    all.extend(control.settings());
    all.extend(method.kind.own.map(|own| (own.key.key, control::written(method.own))));
    all
}

/// Returns the keys of all methods and controls, and of the method itself.
#[must_use]
pub fn setting_keys() -> Vec<&'static str> {
    let read = names().into_iter().flat_map(|(_, named)| named.keys());
    let mut all: Vec<&str> = read.map(|key| key.key).chain(["method"]).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Returns a description of a method and its setting in terms of the scene format.
#[must_use]
pub fn method_words(method: Method, control: Control) -> String {
    control.words(method.kind.name)
}

/// Returns the reference rows of the keys that methods read.
#[must_use]
pub fn reference() -> Vec<KeyReference> {
    let meaning = "the integrator; auto chooses the fastest method that reaches the accuracy. By default exact if no \
                   light is bent, otherwise a method for the given steps or tolerance, otherwise auto";
    let all = names();
    let keys: Vec<Vec<Key>> = all.iter().map(|(_, named)| named.keys()).collect();
    let kinds = all.iter().zip(&keys).map(|((name, _), keys)| (&**name, &**keys));
    let kinds: Vec<(&str, &[Key])> = std::iter::once(("auto", [].as_slice())).chain(kinds).collect();
    kind_rows("rays", ("method", "see the meaning", meaning), &kinds)
}
