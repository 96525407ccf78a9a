//! The methods that a law allows, each with its range of settings.

use crate::program::Regions;
use crate::scene::{Control, DoublingRule, FlowOrder, Law, Medium, Method, Scene, SchwarzschildForm, Segment};

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
    fn new(name: &'static str, method: Method, controls: Vec<Control>) -> Self {
        let closed_forms = matches!(method, Method::Exact | Method::Planar);
        Self { name, method, controls, closed_forms }
    }

    /// The scene with this method at a setting.
    #[must_use]
    pub fn applied(&self, scene: &Scene, control: Control) -> Scene {
        let mut scene = scene.clone();
        scene.rays.auto = None;
        scene.rays.method = self.method;
        scene.rays.control = control;
        scene.rays.closed_forms = self.closed_forms;
        scene
    }
}

/// The setting between two of one kind, by the geometric mean of their numbers.
#[must_use]
pub(super) fn between(a: Control, b: Control) -> Control {
    let mean = |a: f64, b: f64| (a * b).sqrt();
    match (a, b) {
        (Control::Scaled { eta }, Control::Scaled { eta: other }) => Control::Scaled { eta: mean(eta, other) },
        (Control::Embedded { tolerance, eta }, Control::Embedded { tolerance: other, .. }) => {
            Control::Embedded { tolerance: mean(tolerance, other), eta }
        }
        _ => b,
    }
}

/// From `first` on, each `factor` of the one before.
fn falling(first: f64, factor: f64, count: i32) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| first * factor.powi(k))
}

/// Steps of half the law's scale and less: a larger one jumps over what it should see.
fn scaled(count: i32) -> Vec<Control> {
    falling(0.5, 0.75, count).map(|eta| Control::Scaled { eta }).collect()
}

fn embedded(count: i32) -> Vec<Control> {
    falling(1.0, 0.316_227_766, count).map(|tolerance| Control::Embedded { tolerance, eta: 0.5 }).collect()
}

fn doubling(rule: DoublingRule, count: i32) -> Vec<Control> {
    falling(0.1, 0.316_227_766, count)
        .map(|tolerance| Control::Doubling { rule, tolerance, grow_below: 0.1 * tolerance, eta: 0.3 })
        .collect()
}

fn turning(count: i32) -> Vec<Control> {
    falling(0.5, 0.75, count).map(|turn| Control::Curvature { turn, eta: 0.5 }).collect()
}

/// Do accelerations depend on place alone?
fn is_second_order(law: &Law) -> bool {
    !matches!(
        law,
        Law::Flow { order: FlowOrder::Velocity, .. } | Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. }
    )
}

/// Can all its rays be followed in closed form?
fn closed(scene: &Scene) -> bool {
    let scene = Candidate::new("exact", Method::Exact, Vec::new()).applied(scene, Control::Exact);
    !Regions::of(&scene).need_method()
}

fn allows_planar(scene: &Scene) -> bool {
    let arcs = matches!(scene.rays.segment, Segment::Arc { .. });
    let ends = scene.rays.length.is_some();
    let interiors = || scene.objects.iter().filter_map(|object| object.interior());
    let closed = interiors().all(|interior| interior.medium.has_closed_form(ends));
    closed && scene.law.only_center().is_some() && scene.rays.length.is_none() && arcs
}

/// Every method that the scene's law allows.
#[must_use]
pub fn all_methods(scene: &Scene) -> Vec<Candidate> {
    let mut all = Vec::new();
    if closed(scene) {
        all.push(Candidate::new("exact", Method::Exact, vec![Control::Exact]));
    }
    if allows_planar(scene) {
        all.push(Candidate::new("planar", Method::Planar, scaled(16)));
    }
    let rejecting = DoublingRule::Rejecting;
    all.push(Candidate::new("euler", Method::Euler, scaled(18)));
    all.push(Candidate::new("euler-doubling (2004)", Method::Euler, doubling(DoublingRule::Paper, 9)));
    all.push(Candidate::new("euler-doubling", Method::Euler, doubling(rejecting, 9)));
    if is_second_order(&scene.law) {
        all.push(Candidate::new("leapfrog", Method::Leapfrog, scaled(18)));
        all.push(Candidate::new("rkn4", Method::Rkn4, scaled(16)));
    }
    all.push(Candidate::new("rk4", Method::Rk4, scaled(16)));
    all.push(Candidate::new("rk4-curvature", Method::Rk4, turning(16)));
    all.push(Candidate::new("rk4-doubling", Method::Rk4, doubling(rejecting, 12)));
    all.push(Candidate::new("bogacki-shampine", Method::BogackiShampine, embedded(14)));
    all.push(Candidate::new("dormand-prince", Method::DormandPrince, embedded(14)));
    if scene.media().any(Medium::bends) {
        all.push(Candidate::new("snell", Method::Snell { threshold: 0.001 }, scaled(16)));
    }
    all
}

/// Those that a chart has shown to be the fastest somewhere.
#[must_use]
pub fn fast_methods(scene: &Scene) -> Vec<Candidate> {
    if closed(scene) {
        return vec![Candidate::new("exact", Method::Exact, vec![Control::Exact])];
    }
    let fast = ["exact", "planar", "rkn4", "rk4", "dormand-prince"];
    let mut methods: Vec<_> = all_methods(scene).into_iter().filter(|method| fast.contains(&method.name)).collect();
    for method in &mut methods {
        method.closed_forms = true;
    }
    if methods.iter().any(|method| method.name == "rkn4") {
        // The same order for three evaluations where the other has four.
        methods.retain(|method| method.name != "rk4");
    }
    methods
}

/// A method and its setting in words of the scene format.
#[must_use]
pub fn method_words(method: Method, control: Control) -> String {
    let name = match method {
        Method::Exact => "exact",
        Method::Planar => "planar",
        Method::Euler => "euler",
        Method::Leapfrog => "leapfrog",
        Method::Rkn4 => "rkn4",
        Method::Rk4 => "rk4",
        Method::BogackiShampine => "bogacki-shampine",
        Method::DormandPrince => "dormand-prince",
        Method::Snell { .. } => "snell",
    };
    match control {
        Control::Exact => name.to_owned(),
        Control::Fixed { step, .. } => format!("{name}, step {step:.3e}"),
        Control::Scaled { eta } => format!("{name}, scaled_step {eta:.4}"),
        Control::Curvature { turn, .. } => format!("{name}, curvature_step {:.4}", turn.to_degrees()),
        Control::Doubling { rule, tolerance, .. } => {
            let rule = if rule == DoublingRule::Paper { " (paper)" } else { "" };
            format!("{name}-doubling{rule}, tolerance {tolerance:.1e}")
        }
        Control::Embedded { tolerance, .. } => format!("{name}, tolerance {tolerance:.1e}"),
    }
}

/// Evaluations of the law's rate in a path of so many accepted and rejected steps.
#[must_use]
pub fn evaluations(method: Method, control: Control, steps: f64, rejected: f64) -> f64 {
    let step = match method {
        Method::Exact => 0.0,
        Method::Euler | Method::Leapfrog | Method::Snell { .. } => 1.0,
        Method::Rkn4 | Method::Planar | Method::BogackiShampine => 3.0,
        Method::Rk4 => 4.0,
        Method::DormandPrince => 6.0,
    };
    match control {
        Control::Doubling { .. } => 3.0 * step * (steps + rejected),
        Control::Curvature { .. } => (step + 1.0) * steps,
        Control::Embedded { .. } => 1.0 + step * (steps + rejected),
        Control::Exact | Control::Fixed { .. } | Control::Scaled { .. } => step * steps,
    }
}
