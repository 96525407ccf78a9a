//! How light travels: the parts of which every kind of region has a copy of its own.

use super::plan::{Names, chosen};
use super::regions::{Kind, Motion, Regions};
use super::unit::Unit;
use super::{ProgramError, Purpose, formula, generated};
use crate::scene::{
    Control, DoublingRule, Falloff, FlowField, FlowOrder, Formula, Law, Medium, Method, Scene, SchwarzschildForm,
    Segment,
};

/// The parts of one kind of region.
pub(super) fn region_parts(
    scene: &Scene,
    purpose: Purpose,
    regions: &Regions,
    kind: &Kind,
) -> Result<Vec<Unit>, ProgramError> {
    let mut names = Names::default();
    let mut made = Vec::new();
    let leap = kind.leaps;
    names.add(if leap { "leap/sphere" } else { "leap/none" });
    if let Some(index) = kind.index {
        names.all(index);
        made.push(generated::media(kind.media.len()));
        let formulas: Vec<_> = kind.media.iter().filter_map(formula).collect();
        if !formulas.is_empty() {
            made.push(formula::formulas(&formulas));
        }
    } else {
        names.add("index/vacuum");
    }
    let chords = matches!(scene.rays.segment, Segment::Chord { .. });
    let line = chords || kind.is_line();
    names.add(if line { "curve/line" } else { "curve/arc" });
    let whole = kind.motion == Motion::Straight && !chords;
    names.add(if whole { "join/whole" } else { "join/pieces" });
    let planar = kind.motion == Motion::Law && scene.rays.method == Method::Planar;
    names.add(if planar { "bare/orbit" } else { "bare/steps" });
    match kind.motion {
        Motion::Law => law_motion(scene, purpose, &mut names, &mut made),
        Motion::Straight => {
            names.all(&["motion/straight", "pace/tau", "rate/none"]);
            names.add(if kind.index.is_some() { "start/by_index" } else { "start/as_given" });
        }
        Motion::Harmonic => {
            names.all(&["motion/harmonic", "pace/tau", "rate/none", "start/by_index"]);
            let rod = matches!(kind.media.first(), Some(Medium::Rod { .. }));
            names.add(if rod { "spring/rod" } else { "spring/luneburg" });
            names.add(if leap { "stride/harmonic_leap" } else { "stride/harmonic_arc" });
        }
        Motion::Spiral => {
            names.all(&["motion/spiral", "rate/none"]);
            names.add(if leap { "stride/spiral_leap" } else { "stride/spiral_arc" });
            made.push(generated::obstacles(regions.obstacles.len(), scene.rays.leaps));
        }
        Motion::Circle => {
            names.all(&["motion/circle", "rate/none", "start/by_index"]);
            names.add(if leap { "stride/circle_leap" } else { "stride/circle_arc" });
        }
        Motion::Parabola => names.all(&["motion/parabola", "pace/tau", "rate/none", "start/by_index"]),
        Motion::Solved => {
            names.all(&["law/accelerated", "law/medium", "pace/tau", "rate/law"]);
            step_parts(scene.rays.method, &mut names);
            control_parts(scene.rays.control, &mut names);
        }
    }
    let mut units = names.units()?;
    units.extend(made);
    Ok(units)
}

/// What a user wrote for the index.
fn formula(medium: &Medium) -> Option<Formula> {
    match medium {
        Medium::Expression { n, .. } => Some(n.clone()),
        _ => None,
    }
}

/// The scene's own law, by the scene's own method.
fn law_motion(scene: &Scene, purpose: Purpose, names: &mut Names, made: &mut Vec<Unit>) {
    names.add(if scene.rays.method == Method::Planar { "pace/orbit" } else { "pace/tau" });
    if scene.rays.method == Method::Planar || scene.rays.asymptotic {
        orbit_parts(&scene.law, names);
    }
    law_parts(&scene.law, names, made);
    if scene.rays.method == Method::Planar {
        names.add("rate/none");
        planar_parts(scene, purpose, names);
        return;
    }
    names.add("rate/law");
    step_parts(scene.rays.method, names);
    control_parts(scene.rays.control, names);
}

/// The plane of a ray about its law's only centre.
fn orbit_parts(law: &Law, names: &mut Names) {
    names.add("orbit/orbit");
    match law {
        Law::Schwarzschild { .. } => names.add("orbit/schwarzschild"),
        Law::Sources(sources) => names.add(match sources.first().map(|source| source.falloff) {
            Some(Falloff::Cubic { .. }) => "orbit/cubic",
            Some(Falloff::Yukawa { .. }) => "orbit/yukawa",
            _ => "orbit/inverse_square",
        }),
        _ => {}
    }
}

/// τ is integrated only where something asks for it: arcs, and the numbers of a trace.
fn planar_parts(scene: &Scene, purpose: Purpose, names: &mut Names) {
    let open = scene.objects.is_empty();
    names.add(if open { "motion/planar_open" } else { "motion/planar" });
    let asked = !open || !matches!(purpose, Purpose::Picture | Purpose::Bare);
    names.add(if asked { "clock/kept" } else { "clock/none" });
}

fn step_parts(method: Method, names: &mut Names) {
    match method {
        Method::Exact | Method::Planar => {}
        Method::Euler => names.add("step/euler"),
        Method::Leapfrog => names.add("step/leapfrog"),
        Method::Rkn4 => names.add("step/rkn4"),
        Method::Rk4 => names.add("step/rk4"),
        Method::Snell { .. } => names.add("step/snell"),
        Method::BogackiShampine => names.all(&["step/pair", "step/bogacki_shampine"]),
        Method::DormandPrince => names.all(&["step/pair", "step/dormand_prince"]),
    }
}

fn control_parts(control: Control, names: &mut Names) {
    match control {
        Control::Exact => {}
        Control::Fixed { .. } => names.all(&["control/planned", "control/fixed"]),
        Control::Scaled { .. } => names.all(&["control/planned", "control/scaled"]),
        Control::Curvature { .. } => names.all(&["control/planned", "control/curvature"]),
        Control::Embedded { .. } => names.add("control/embedded"),
        Control::Doubling { rule: DoublingRule::Paper, .. } => {
            names.all(&["control/doubled", "control/doubling_paper"]);
        }
        Control::Doubling { rule: DoublingRule::Rejecting, .. } => {
            names.all(&["control/doubled", "control/doubling_rejecting"]);
        }
    }
}

fn law_parts(law: &Law, names: &mut Names, made: &mut Vec<Unit>) {
    let second_order = !matches!(
        law,
        Law::Flow { order: FlowOrder::Velocity, .. } | Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. }
    );
    if second_order {
        names.add("law/accelerated");
    }
    match law {
        Law::Straight => names.add("law/straight"),
        Law::Schwarzschild { form: SchwarzschildForm::Path, .. } => names.add("law/schwarzschild_path"),
        Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. } => names.add("law/schwarzschild_geodesic"),
        Law::Sources(sources) => {
            let falloffs = chosen(&[
                ("inverse_square", sources.iter().any(|s| s.falloff == Falloff::InverseSquare)),
                ("cubic", sources.iter().any(|s| matches!(s.falloff, Falloff::Cubic { .. }))),
                ("yukawa", sources.iter().any(|s| matches!(s.falloff, Falloff::Yukawa { .. }))),
            ]);
            names.all(&["law/sources", "falloff/far_away"]);
            names.each("falloff", falloffs.iter().copied());
            made.push(generated::sources(&falloffs));
        }
        Law::Flow { field, order } => {
            names.add(match field {
                FlowField::Lorenz { .. } => "flow/lorenz",
                FlowField::Rossler { .. } => "flow/rossler",
            });
            names.add(match order {
                FlowOrder::Velocity => "law/flow",
                FlowOrder::Acceleration => "law/flow_acceleration",
            });
        }
        Law::Medium(_) => names.add("law/medium"),
    }
}
