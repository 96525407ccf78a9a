//! The methods that a law allows, each with its range of settings.

use crate::model::control::PLANNED;
use crate::model::law::UsualSteps;
use crate::model::method::{CLOSED_FORMS, Kind, METHODS, Path, TOLERANT};
use crate::model::{Control, Method};
use crate::scene::Scene;

/// A method with its settings, from coarse to fine: numbers of one and the same kind of control.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// As in a scene file, with what else tells it from the others.
    pub name: &'static str,
    /// The integrator.
    pub method: Method,
    /// Its settings.
    pub controls: Vec<Control>,
    /// Do closed forms stand for it where there are some?
    pub closed_forms: bool,
}

impl Candidate {
    fn all_of(kind: &'static Kind) -> impl Iterator<Item = Self> {
        let (method, closed_forms) = (Method::new(kind), kind.closed_forms);
        (kind.sweeps)().into_iter().map(move |(name, controls)| Self { name, method, controls, closed_forms })
    }

    /// The scene with this method at a setting.
    #[must_use]
    pub fn applied(&self, scene: &Scene, control: Control) -> Scene {
        scene.followed_by(self.method, control, self.closed_forms)
    }
}

/// Every method that the scene's law allows.
#[must_use]
pub fn all_methods(scene: &Scene) -> Vec<Candidate> {
    let demands = scene.demands();
    let allowed = METHODS.into_iter().filter(|kind| (kind.refuses)(&demands).is_empty());
    allowed.flat_map(Candidate::all_of).collect()
}

/// Those that a chart has shown to be the fastest somewhere; where no light is bent, none but closed forms.
#[must_use]
pub fn fast_methods(scene: &Scene) -> Vec<Candidate> {
    if !scene.demands().needs_solver {
        return Candidate::all_of(CLOSED_FORMS.kind).collect();
    }
    let is_fast = |candidate: &Candidate| {
        candidate.method.kind.step_cost.is_some() && candidate.name == candidate.method.kind.name
    };
    let mut methods: Vec<_> = all_methods(scene).into_iter().filter(is_fast).collect();
    for method in &mut methods {
        method.closed_forms = true;
    }
    let all: Vec<&Kind> = methods.iter().map(|candidate| candidate.method.kind).collect();
    methods.retain(|candidate| !all.iter().any(|other| outdoes(other, candidate.method.kind)));
    methods
}

/// The one that is probably the cheapest of them, by what is known of the law.
#[must_use]
pub fn usual_method(scene: &Scene) -> Option<Candidate> {
    let mut all = fast_methods(scene);
    let is_usual = |candidate: &Candidate| match scene.law.facts().usual_steps {
        UsualSteps::Orbit => candidate.method.kind.path != Path::Steps || candidate.method == TOLERANT,
        UsualSteps::Tolerant => candidate.method.kind.path == Path::Closed || candidate.method == TOLERANT,
        UsualSteps::Scaled => true,
    };
    let at = all.iter().position(is_usual)?;
    Some(all.swap_remove(at))
}

/// Is it of the same order for fewer evaluations of the same derivative, by steps that are planned likewise?
fn outdoes(other: &Kind, kind: &Kind) -> bool {
    let planned = |kind: &Kind| kind.path == Path::Steps && kind.controls.starts_with(&PLANNED);
    planned(other) && planned(kind) && other.order == kind.order && other.evaluations < kind.evaluations
}

/// What meeting an object costs a step, in evaluations of a simple derivative, and the objects from which on a structure sorts them.
const OBJECT_COST: f64 = 4.0;
const SORTED: usize = 12;

/// What a path of so many accepted and rejected steps costs, in evaluations of a simple derivative: from a half to three nanoseconds
/// on two CPU cores. What is compared is methods on one scene, for which the numbers were found: in charts of the shipped scenes the
/// cheapest of [`fast_methods`] takes no longer than the others, but for noise. They do not tell how long another scene takes.
#[must_use]
pub fn cost(scene: &Scene, method: Method, control: Control, steps: f64, rejected: f64) -> f64 {
    let terms = f64::from(scene.law.facts().terms.max(1));
    let objects = OBJECT_COST * scene.objects.len().min(SORTED) as f64;
    let own = method.kind.step_cost.unwrap_or(0.0);
    terms * evaluations(method, control, steps, rejected) + own * (steps + rejected) + objects * steps
}

/// Evaluations of the law's derivative in a path of so many accepted and rejected steps.
#[must_use]
pub fn evaluations(method: Method, control: Control, steps: f64, rejected: f64) -> f64 {
    (control.kind.evaluations)(method.kind.evaluations.into(), steps, rejected)
}
