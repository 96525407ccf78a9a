//! Choice of the modules for the motion of light, of which every kind of region has a copy.

use super::features::joins_whole;
use super::names::Names;
use super::regions::{Motion, RegionKind, Regions};
use super::unit::Unit;
use super::{Features, ProgramError, formula, generated, spacetime};
use crate::model::law::SOLVED_PARTS;
use crate::model::{ClosedForm, Start};
use crate::scene::Scene;

/// Returns the modules of one kind of region.
pub(super) fn region_parts(
    scene: &Scene,
    features: &Features,
    regions: &Regions,
    kind: &RegionKind,
) -> Result<Vec<Unit>, ProgramError> {
    let mut names = Names::default();
    names.add("motion/leap");
    names.make(generated::region(kind.leaps, joins_whole(scene, kind)));
    names.add("segment/join");
    if let Some(index) = &kind.index {
        names.wgsl(index.iter().cloned())?;
        names.make(generated::media(kind.media.len()));
        let formulas: Vec<_> = kind.media.iter().filter_map(|medium| medium.facts().formula.cloned()).collect();
        if !formulas.is_empty() {
            names.make(formula::formulas(&formulas));
        }
    } else {
        names.add("medium/vacuum");
    }
    let chords = scene.rays.segment.has_chords();
    names.add(if chords || kind.is_line() { "segment/curve_line" } else { "segment/curve_arc" });
    let orbit = kind.motion == Motion::Law && features.on_orbit;
    names.add(if orbit { "motion/orbit" } else { "motion/bare_steps" });
    match kind.motion {
        Motion::Law => law_motion(scene, features, &mut names)?,
        Motion::Closed(form) => closed_motion(form, scene, regions, kind, &mut names)?,
        Motion::Solved => {
            names.all(&SOLVED_PARTS);
            names.all(&["motion/pace_tau", "method/first_derivative"]);
            names.all(scene.rays.method.kind.parts);
            names.all(scene.rays.control.kind.parts);
        }
    }
    if features.volumes.transfers && !features.volumes.transfers_orbits {
        let is_closed = matches!(kind.motion, Motion::Closed(_)) || orbit;
        names.add(if is_closed { "volume/step_retaken" } else { "volume/step_interpolated" });
    }
    names.units()
}

/// Adds the modules for a motion in closed form.
fn closed_motion(
    form: &ClosedForm,
    scene: &Scene,
    regions: &Regions,
    kind: &RegionKind,
    names: &mut Names,
) -> Result<(), ProgramError> {
    names.all(form.parts);
    if let Some(curve) = scene.law.facts().curve() {
        names.wgsl(scene.law.parts())?;
        names.make(formula::curve(&curve.curve));
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

/// Adds the modules for the scene's law and method.
fn law_motion(scene: &Scene, features: &Features, names: &mut Names) -> Result<(), ProgramError> {
    let on_orbit = features.on_orbit;
    let facts = scene.law.facts();
    let orbit = facts.orbit;
    match orbit.filter(|_| on_orbit) {
        Some(_) => names.all(&["motion/orbit", "motion/pace_orbit"]),
        None => names.add("motion/pace_tau"),
    }
    let asked = features.is_asymptotic || features.shoots || features.is_extreme;
    if let Some(orbit) = orbit.filter(|_| on_orbit || asked) {
        names.all(&orbit.parts());
    }
    names.wgsl(scene.law.parts())?;
    if let Some(curve) = facts.curve() {
        names.make(formula::curve(&curve.curve));
    }
    if let Some(element) = facts.line_element() {
        names.make(spacetime::line_element(element));
    }
    if orbit.is_some() && on_orbit {
        names.all(&["motion/closed", "motion/time"]);
        orbit_parts(features, names);
        return Ok(());
    }
    names.add("method/first_derivative");
    names.all(scene.rays.method.kind.parts);
    names.all(scene.rays.control.kind.parts);
    Ok(())
}

/// Adds the modules for the ends of orbits, and for their division into arcs.
fn orbit_parts(features: &Features, names: &mut Names) {
    match (features.needs_arcs, features.ends_with_steps) {
        (true, _) => names.add("motion/orbit_arcs"),
        (false, true) => {
            names.add("motion/separated_open");
            names.when(features.volumes.transfers_orbits, &["motion/separated_lit"]);
        }
        (false, false) => names.all(&["motion/orbit_open", "motion/edge"]),
    }
}
