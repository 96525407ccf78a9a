//! The methods that a law allows, each with a range of settings.

use crate::model::control::PLANNED;
use crate::model::law::UsualSteps;
use crate::model::method::{CLOSED_FORMS, METHODS, MethodKind, Path, TOLERANT};
use crate::model::{Control, Method};
use crate::scene::Scene;

/// A method with settings of one kind of control, from coarse to fine.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The name in a scene file, with an additional distinction if necessary.
    pub name: &'static str,
    /// The integration method.
    pub method: Method,
    /// The settings.
    pub controls: Vec<Control>,
    /// Is `true` if closed forms replace the method where they exist.
    pub closed_forms: bool,
}

impl Candidate {
    fn all_of(kind: &'static MethodKind) -> impl Iterator<Item = Self> {
        let (method, closed_forms) = (Method::new(kind), kind.closed_forms);
        (kind.sweeps)().into_iter().map(move |(name, controls)| Self { name, method, controls, closed_forms })
    }

    /// Returns the scene with this method at a setting.
    #[must_use]
    pub fn applied(&self, scene: &Scene, control: Control) -> Scene {
        scene.followed_by(self.method, control, self.closed_forms)
    }
}

/// Returns every method that the scene's law allows.
#[must_use]
pub fn all_methods(scene: &Scene) -> Vec<Candidate> {
    let demands = scene.demands();
    let allowed = METHODS.into_iter().filter(|kind| (kind.refuses)(&demands).is_empty());
    allowed.flat_map(Candidate::all_of).collect()
}

/// Returns the methods that are fastest in some chart, or only closed forms if no light is bent.
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
    let all: Vec<&MethodKind> = methods.iter().map(|candidate| candidate.method.kind).collect();
    methods.retain(|candidate| !all.iter().any(|other| outdoes(other, candidate.method.kind)));
    methods
}

/// Returns the method that is probably the cheapest for the law.
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

/// Returns the method that is tried if `method` is not accurate: a tolerance, which also shortens steps where the law changes suddenly.
pub(super) fn next_method(scene: &Scene, method: Method) -> Option<Candidate> {
    let is_next = |candidate: &Candidate| candidate.method == TOLERANT && method.kind.path == Path::Steps;
    fast_methods(scene).into_iter().find(is_next).filter(|next| next.method != method)
}

/// Returns `true` if the other method has equal order and planned steps with fewer evaluations of the same derivative.
fn outdoes(other: &MethodKind, kind: &MethodKind) -> bool {
    let planned = |kind: &MethodKind| kind.path == Path::Steps && kind.controls.starts_with(&PLANNED);
    planned(other) && planned(kind) && other.order == kind.order && other.evaluations < kind.evaluations
}

/// The cost of an intersection test per step, in evaluations of a simple derivative, and the number of objects above which an acceleration
/// structure sorts them.
const OBJECT_COST: f64 = 4.0;
const SORTED: usize = 12;

/// Returns the cost of a path with these accepted and rejected steps, in evaluations of a simple derivative, which take 0.5 to 3 ns on two
/// CPU cores. The numbers are fitted to compare methods on one scene: in charts of the shipped scenes, the cheapest of [`fast_methods`] is
/// the fastest, except for noise. They do not predict the time of another scene.
#[must_use]
pub fn cost(scene: &Scene, method: Method, control: Control, steps: f64, rejected: f64) -> f64 {
    let terms = f64::from(scene.law.facts().terms.max(1));
    let objects = OBJECT_COST * scene.objects.len().min(SORTED) as f64;
    let own = method.kind.step_cost.unwrap_or(0.0);
    terms * evaluations(method, control, steps, rejected) + own * (steps + rejected) + objects * steps
}

/// Returns the derivative evaluations of a path with these accepted and rejected steps.
#[must_use]
pub fn evaluations(method: Method, control: Control, steps: f64, rejected: f64) -> f64 {
    (control.kind.evaluations)(method.kind.evaluations.into(), steps, rejected)
}
