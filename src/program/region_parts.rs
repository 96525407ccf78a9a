//! How light travels: the parts of which every kind of region has a copy of its own.

use super::names::Names;
use super::regions::{Motion, RegionKind, Regions};
use super::unit::Unit;
use super::{Choice, ProgramError, Purpose, formula, generated, spacetime};
use crate::model::law::{Orbit, OrbitForm, SOLVED_PARTS};
use crate::model::method::Path;
use crate::model::{ClosedForm, Start, Wgsl};
use crate::scene::{Scene, Shadows};

/// The parts of one kind of region.
pub(super) fn region_parts(
    scene: &Scene,
    choice: &Choice,
    regions: &Regions,
    kind: &RegionKind,
) -> Result<Vec<Unit>, ProgramError> {
    let mut names = Names::default();
    names.add(if kind.leaps { "motion/leap_sphere" } else { "motion/leap_none" });
    if let Some(index) = &kind.index {
        names.wgsl(index.iter().cloned())?;
        names.make(generated::media(kind.media.len()));
        let formulas: Vec<_> = kind.media.iter().filter_map(|medium| medium.formula().cloned()).collect();
        if !formulas.is_empty() {
            names.make(formula::formulas(&formulas));
        }
    } else {
        names.add("medium/vacuum");
    }
    let chords = scene.rays.segment.has_chords();
    names.add(if chords || kind.is_line() { "segment/curve_line" } else { "segment/curve_arc" });
    names.add(match (joins_whole(scene, kind), scene.looks_from_surfaces()) {
        (true, _) => "segment/join_whole",
        (false, _) if choice.follows_paths(scene) => "segment/join_scattered",
        (false, false) => "segment/join_pieces",
        (false, true) => "segment/join_lit",
    });
    let orbit = kind.motion == Motion::Law && scene.rays.method.kind.path == Path::Orbit;
    names.add(if orbit { "motion/orbit" } else { "motion/bare_steps" });
    match kind.motion {
        Motion::Law => law_motion(scene, choice, &mut names)?,
        Motion::Closed(form) => closed_motion(form, scene, regions, kind, &mut names)?,
        Motion::Solved => {
            names.all(&SOLVED_PARTS);
            names.all(&["law/path_as_velocity", "motion/pace_tau", "method/first_derivative"]);
            names.all(scene.rays.method.kind.parts);
            names.all(scene.rays.control.kind.parts);
        }
    }
    names.units()
}

/// Are its paths whole lines, which begin where a ray does?
pub(super) fn joins_whole(scene: &Scene, kind: &RegionKind) -> bool {
    kind.motion.closed_form().is_some_and(|form| form.is_line) && !scene.rays.segment.has_chords()
}

/// A motion in closed form.
fn closed_motion(
    form: &ClosedForm,
    scene: &Scene,
    regions: &Regions,
    kind: &RegionKind,
    names: &mut Names,
) -> Result<(), ProgramError> {
    names.all(form.parts);
    names.add("law/path_as_velocity");
    if let Some(curve) = scene.law.facts().curve() {
        names.wgsl(scene.law.parts())?;
        names.make(formula::curve(&curve.curve));
    }
    if let Some([arc, leap]) = form.strides {
        names.add(if kind.leaps { leap } else { arc });
    }
    if form.meets_obstacles {
        names.make(generated::obstacles(regions.obstacles.len(), scene.rays.leaps));
    }
    match form.start {
        Start::Own => {}
        Start::ByIndexIfAny if kind.index.is_none() => names.add("law/start_as_given"),
        Start::ByIndex | Start::ByIndexIfAny => names.add("law/start_by_index"),
    }
    Ok(())
}

/// The scene's own law, by the scene's own method.
fn law_motion(scene: &Scene, choice: &Choice, names: &mut Names) -> Result<(), ProgramError> {
    let on_orbit = scene.rays.method.kind.path == Path::Orbit;
    let [path, pace] = scene.law.facts().pace;
    let orbit = scene.law.facts().orbit;
    match orbit.filter(|_| on_orbit) {
        Some(orbit) => {
            names.all(&[path, "motion/orbit"]);
            names.add(if orbit.is_plane() { "motion/pace_plane" } else { "motion/pace_spheroid" });
        }
        None => names.all(&[path, pace]),
    }
    let shoots = choice.purpose == Purpose::Lit || scene.has_shadows(Shadows::Shooting);
    let asked = scene.rays.asymptotic || shoots || scene.law.facts().capture_part.is_some();
    if let Some(orbit) = orbit.filter(|_| on_orbit || asked) {
        names.all(&orbit.parts());
    }
    let stretched = |part: Wgsl| {
        let follows = part == Wgsl::Part("law/by_time".into()) && choice.follows_shift(scene);
        if follows { Wgsl::Part("law/by_time_stretched".into()) } else { part }
    };
    names.wgsl(scene.law.parts().into_iter().map(stretched))?;
    if let Some(curve) = scene.law.facts().curve() {
        names.make(formula::curve(&curve.curve));
    }
    if let Some(element) = scene.law.facts().line_element() {
        names.make(spacetime::line_element(element));
    }
    if let Some(orbit) = orbit.filter(|_| on_orbit) {
        names.add("motion/closed");
        orbit_parts(scene, &orbit, choice.purpose, names);
        return Ok(());
    }
    names.add("method/first_derivative");
    names.all(scene.rays.method.kind.parts);
    names.all(scene.rays.control.kind.parts);
    Ok(())
}

/// Does the last step of a path end where the path does? So where orbits separate and there is nothing to hit.
pub(super) fn ends_with_steps(scene: &Scene) -> bool {
    let separates = scene.law.facts().orbit.is_some_and(|orbit| !orbit.is_plane());
    let on_orbit = scene.rays.method.kind.path == Path::Orbit;
    on_orbit && separates && !scene.needs_arcs() && is_about_center(scene)
}

/// Is the bounding sphere about the orbits' centre, in every frame?
fn is_about_center(scene: &Scene) -> bool {
    let moves = |key: &String| key.starts_with("law.") || key.starts_with("rays.bound");
    let is_still = scene.animation.as_ref().is_none_or(|animation| !animation.keys.iter().any(moves));
    is_still && scene.law.facts().orbit.is_some_and(|orbit| orbit.center == scene.rays.bound.center)
}

/// τ is integrated only where something asks for it: arcs, and the numbers of a trace.
fn orbit_parts(scene: &Scene, orbit: &Orbit, purpose: Purpose, names: &mut Names) {
    let open = !scene.needs_arcs();
    if ends_with_steps(scene) {
        names.add("motion/separated_open");
    } else if open {
        names.add("motion/orbit_open");
        names.add(if is_about_center(scene) { "motion/edge_bound" } else { "motion/edge_within" });
    } else {
        names.add("motion/orbit_arcs");
        names.add(if orbit.is_plane() { "motion/arcs_plane" } else { "motion/arcs_dragged" });
    }
    let asked = !open || !matches!(purpose, Purpose::Picture | Purpose::Bare);
    names.add(match orbit.form {
        _ if !asked => "motion/time_none",
        OrbitForm::Plane(_) => "motion/time_kept",
        OrbitForm::Separated(_) => "motion/time_separated",
    });
}
