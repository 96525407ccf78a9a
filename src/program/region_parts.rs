//! How light travels: the parts of which every kind of region has a copy of its own.

use super::link::Unit;
use super::plan::{Names, chosen};
use super::regions::{Kind, Motion, Regions};
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
    names.add(if leap { "motion/leap_sphere" } else { "motion/leap_none" });
    if let Some(index) = kind.index {
        names.all(index);
        made.push(generated::media(kind.media.len()));
        let formulas: Vec<_> = kind.media.iter().filter_map(formula).collect();
        if !formulas.is_empty() {
            made.push(formula::formulas(&formulas));
        }
    } else {
        names.add("medium/vacuum");
    }
    let chords = matches!(scene.rays.segment, Segment::Chord { .. });
    let line = chords || kind.is_line();
    names.add(if line { "segment/curve_line" } else { "segment/curve_arc" });
    let whole = kind.motion == Motion::Straight && !chords;
    names.add(if whole { "segment/join_whole" } else { "segment/join_pieces" });
    let planar = kind.motion == Motion::Law && scene.rays.method == Method::Planar;
    names.add(if planar { "motion/orbit" } else { "motion/bare_steps" });
    match kind.motion {
        Motion::Law => law_motion(scene, purpose, &mut names, &mut made),
        Motion::Straight => {
            names.all(&["motion/straight", "motion/pace_tau", "motion/closed"]);
            names.add(if kind.index.is_some() { "law/start_by_index" } else { "law/start_as_given" });
        }
        Motion::Harmonic => {
            names.all(&["motion/harmonic", "motion/pace_tau", "motion/closed", "law/start_by_index"]);
            names.add(if leap { "motion/harmonic_leap" } else { "motion/harmonic_arc" });
        }
        Motion::Spiral => {
            names.all(&["motion/spiral", "motion/closed"]);
            names.add(if leap { "motion/spiral_leap" } else { "motion/spiral_arc" });
            made.push(generated::obstacles(regions.obstacles.len(), scene.rays.leaps));
        }
        Motion::Circle => {
            names.all(&["motion/circle", "motion/closed", "law/start_by_index"]);
            names.add(if leap { "motion/circle_leap" } else { "motion/circle_arc" });
        }
        Motion::Parabola => names.all(&["motion/parabola", "motion/pace_tau", "motion/closed", "law/start_by_index"]),
        Motion::Solved => {
            names.all(&["law/accelerated", "law/medium", "motion/pace_tau", "method/first_derivative"]);
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
    names.add(if scene.rays.method == Method::Planar { "motion/orbit" } else { "motion/pace_tau" });
    if scene.rays.method == Method::Planar || scene.rays.asymptotic {
        orbit_parts(&scene.law, names);
    }
    law_parts(&scene.law, names, made);
    if scene.rays.method == Method::Planar {
        names.add("motion/closed");
        planar_parts(scene, purpose, names);
        return;
    }
    names.add("method/first_derivative");
    step_parts(scene.rays.method, names);
    control_parts(scene.rays.control, names);
}

/// The plane of a ray about its law's only centre.
fn orbit_parts(law: &Law, names: &mut Names) {
    names.add("law/orbit");
    match law {
        Law::Schwarzschild { .. } => names.add("law/orbit/schwarzschild"),
        Law::Sources(sources) => names.add(match sources.first().map(|source| source.falloff) {
            Some(Falloff::Cubic { .. }) => "law/orbit/cubic",
            Some(Falloff::Yukawa { .. }) => "law/orbit/yukawa",
            _ => "law/orbit/inverse_square",
        }),
        _ => {}
    }
}

/// τ is integrated only where something asks for it: arcs, and the numbers of a trace.
fn planar_parts(scene: &Scene, purpose: Purpose, names: &mut Names) {
    let open = scene.objects.is_empty();
    names.add(if open { "motion/orbit_open" } else { "motion/orbit_arcs" });
    let asked = !open || !matches!(purpose, Purpose::Picture | Purpose::Bare);
    names.add(if asked { "motion/time_kept" } else { "motion/time_none" });
}

fn step_parts(method: Method, names: &mut Names) {
    match method {
        Method::Exact | Method::Planar => {}
        Method::Euler => names.add("method/step/euler"),
        Method::Leapfrog => names.add("method/step/leapfrog"),
        Method::Rkn4 => names.add("method/step/rkn4"),
        Method::Rk4 => names.add("method/step/rk4"),
        Method::Snell { .. } => names.add("method/step/snell"),
        Method::BogackiShampine => names.all(&["method/control/embedded", "method/step/bogacki_shampine"]),
        Method::DormandPrince => names.all(&["method/control/embedded", "method/step/dormand_prince"]),
    }
}

fn control_parts(control: Control, names: &mut Names) {
    match control {
        Control::Exact => {}
        Control::Fixed { .. } => names.all(&["method/control/planned", "method/control/fixed"]),
        Control::Scaled { .. } => names.all(&["method/control/planned", "method/control/scaled"]),
        Control::Curvature { .. } => names.all(&["method/control/planned", "method/control/curvature"]),
        Control::Embedded { .. } => names.add("method/control/embedded"),
        Control::Doubling { rule: DoublingRule::Paper, .. } => {
            names.all(&["method/control/doubled", "method/control/doubling_paper"]);
        }
        Control::Doubling { rule: DoublingRule::Rejecting, .. } => {
            names.all(&["method/control/doubled", "method/control/doubling_rejecting"]);
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
            names.all(&["law/sources"]);
            names.each("law/falloff", falloffs.iter().copied());
            made.push(generated::sources(&falloffs));
        }
        Law::Flow { field, order } => {
            names.add(match field {
                FlowField::Lorenz { .. } => "law/field_lorenz",
                FlowField::Rossler { .. } => "law/field_rossler",
            });
            names.add(match order {
                FlowOrder::Velocity => "law/flow",
                FlowOrder::Acceleration => "law/flow_acceleration",
            });
        }
        Law::Medium(_) => names.add("law/medium"),
    }
}
