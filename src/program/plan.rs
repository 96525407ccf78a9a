//! The plan: which parts a scene is made of. One file per contract; the cheapest that is right for the scene.

use super::names::Names;
use super::onward_parts::{filter_parts, scatter_parts};
use super::picture_parts::{camera_parts, material_parts, picture_parts, samples_part};
use super::region_parts::{ends_with_steps, joins_whole, region_parts};
use super::regions::{RegionKind, Regions};
use super::structure::solids;
use super::unit::Parts;
use super::{Analysis, Choice, Masks, ProgramError, Purpose, Schedule, generated, short_lists};
use crate::model::method::Path;
use crate::model::source::ANCHORS;
use crate::scene::{Precision, Scene, Segment, Shadows};

/// Steps of a chord up to which they are written out.
const WRITTEN_OUT: u32 = 16;

/// The parts of `scene`'s program; its walks through the structure may be suspended if `suspends`. Parts of a contract that a pass does not call are left out when it is linked.
pub fn plan(scene: &Scene, analysis: &Analysis, choice: &Choice, suspends: bool) -> Result<Parts, ProgramError> {
    let mut names = Names::default();
    names.all(&[
        "segment/ray",
        "state/arguments",
        "law/leaving",
        "real/math",
        "state/tally",
        "segment/termination",
        "segment/path_start",
        "segment/ends",
        "segment/follow_path",
        "picture/colors",
    ]);
    match choice.device.loop_budget {
        Some(budget) => {
            names.add("state/loop_budget");
            names.make(generated::loop_budget(budget));
        }
        None => names.add("state/loops_free"),
    }
    names.add(match (choice.follows_paths(scene), choice.sees_glow(scene)) {
        (true, _) => "picture/shade_path",
        (false, true) => "picture/shade_glow",
        (false, false) => "picture/shade_ray",
    });
    names.all(&["state/ray", "state/active", "state/finish"]);
    names.all(match scene.rays.precision {
        Precision::Half => &["real/f32", "state/texture", "state/texels_f16"],
        Precision::Single => &["real/f32", "state/texture", "state/texels_f32"],
        Precision::Double => &["real/f64", "state/buffer"],
    });
    let regions = &analysis.regions;
    names.make(generated::counts(scene, choice, regions));
    names.add(if scene.law.facts().throat.is_some() { "law/bound_mouths" } else { "law/bound" });
    phase_parts(scene, choice, &mut names);
    scatter_parts(scene, choice, regions, &mut names);
    names.each("pass", choice.passes(scene).iter().map(|pass| pass.entry()));
    schedule_parts(scene, choice, regions, &mut names);
    camera_parts(scene, choice, &mut names);
    end_parts(scene, choice, &mut names)?;
    surface_parts(scene, choice, suspends, analysis, &mut names);
    if choice.purpose == Purpose::Picture {
        picture_parts(scene, choice, &mut names)?;
    }
    if !scene.pictures.is_empty() {
        names.add("surface/image_bilinear");
        names.add(if choice.keeps_footprints(scene) { "surface/image_filtered" } else { "surface/image_sample" });
        names.make(generated::images(scene.pictures.len()));
    }
    if !scene.objects.is_empty() {
        material_parts(scene, choice, &mut names);
    }
    shadow_parts(scene, choice, regions, &mut names);
    if scene.disperses() {
        spectrum_parts(scene, choice, &mut names);
    }
    if choice.filters(scene) {
        filter_parts(scene, choice, regions, &mut names);
    }
    let of_kind = |kind: &RegionKind| region_parts(scene, choice, regions, kind);
    let lengths = short_lists::lengths(scene, regions);
    let shared = names.units()?.into_iter().map(|unit| short_lists::in_uniforms(unit, &lengths)).collect();
    let parts = Parts { shared, regions: regions.kinds.iter().map(of_kind).collect::<Result<_, _>>()? };
    Ok(parts.without_optional_calls())
}

/// Whether what is seen lies in a light's shadow, and what of ambient light reaches it.
fn shadow_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    let looks = scene.looks_from_surfaces();
    let shot = scene.has_shadows(Shadows::Shooting) || choice.purpose == Purpose::Lit;
    let leaves = looks || shot || choice.follows_paths(scene);
    let starts = if leaves { "surface/shadow/start_off" } else { "surface/shadow/start_on" };
    let status = if looks || shot { "surface/shadow/status_counted" } else { "surface/shadow/status_sure" };
    names.all(&[starts, status]);
    if shot {
        let planar = scene.law.facts().orbit.is_some_and(|orbit| orbit.is_plane());
        names.all(&["surface/shot/shot", "surface/shot/path"]);
        names.add(if planar { "surface/shot/planar" } else { "surface/shot/newton" });
        names.add(if scene.objects.is_empty() { "surface/shot/clear_space" } else { "surface/shot/clear" });
    }
    if let Some(occlusion) = scene.occlusion.filter(|_| scene.is_occluded()) {
        names.add(if occlusion.along_law { "surface/occlusion/along" } else { "surface/occlusion/line" });
        names.add("surface/shadow/met");
        names.all(&["surface/occlusion/drawn", "surface/scatter/lobe", "surface/scatter/lobe_random"]);
        names.add("camera/sample/scrambled");
    }
    line_parts(scene, choice, names);
    let lines = regions.kinds.iter().all(|kind| joins_whole(scene, kind));
    names.add(if lines { "surface/shadow/line_alike" } else { "surface/shadow/line_marked" });
}

/// Which lights cast straight shadows, and what lets them through.
fn line_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    if !scene.follows_lines() {
        names.add("surface/shadow/none");
        return;
    }
    names.all(&["surface/shadow/clear_kinds", "surface/scatter/frosted", "surface/scatter/microfacet"]);
    if scene.weakens_lines() {
        names.all(&["surface/shadow/filtered", "surface/shadow/met"]);
        names.add(if scene.splits() { "surface/shadow/crossing_clear" } else { "surface/shadow/crossing_opaque" });
        if !choice.filters(scene) {
            names.add("surface/shadow/filtered_none");
        }
        return;
    }
    names.add("surface/shadow/straight");
    let all = scene.lights.iter().all(|light| light.shadows == Shadows::Straight);
    let shut_out = scene.shuts_out();
    names.add(match (all, shut_out) {
        (true, _) => "surface/shadow/of_all",
        (false, true) => "surface/shadow/of_several",
        (false, false) => "surface/shadow/of_some",
    });
    names.add(match scene.splits() {
        true if shut_out => "surface/shadow/clear_chosen",
        true if scene.has_rough_glass() => "surface/shadow/clear_rough",
        true => "surface/shadow/clear",
        false => "surface/shadow/opaque",
    });
}

/// Of which wavelength light is.
fn spectrum_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    match choice.purpose {
        Purpose::Picture if choice.follows_paths(scene) => {
            names.all(&["path/spectrum/drawn", "path/spectrum/of_path", "path/spectrum/color"]);
        }
        Purpose::Caustics => {
            names.all(&["path/spectrum/drawn", "path/spectrum/of_light", "camera/sample/scrambled"]);
        }
        _ => names.add("medium/wavelength"),
    }
}

fn schedule_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    names.add(match choice.masks {
        Masks::Off => "state/active/all",
        Masks::Grid => "state/active/grid",
        Masks::List => "state/active/list",
    });
    if choice.purpose.leaves_light() {
        names.all(&["segment/run_light", "segment/leave_light"]);
    } else {
        names.add(if choice.masks == Masks::Off { "segment/run_all" } else { "segment/run_active" });
    }
    names.add(match (choice.lists_open(scene), choice.rounds(scene) > 1) {
        (false, _) => "state/round/once",
        (true, false) => "state/round/chosen",
        (true, true) => "state/round/open",
    });
    names.add(samples_part(scene, choice));
    names.add(if choice.slots(scene) == 3 { "state/slots_three" } else { "state/slots_two" });
    names.add(if choice.keeps_counts() { "state/counts_kept" } else { "state/counts_none" });
    names.add(if scene.rays.control.kind.rejects { "state/rejections_some" } else { "state/rejections_none" });
    names.add(if keeps_taken(scene, regions) { "state/taken_kept" } else { "state/taken_none" });
}

/// Arcs that are not straight need their step's size in the pass that intersects them.
fn keeps_taken(scene: &Scene, regions: &Regions) -> bool {
    let arcs = !scene.rays.segment.has_chords() && !regions.kinds.iter().all(RegionKind::is_line);
    arcs && !scene.objects.is_empty()
}

/// What a state is, and what the control remembers of it.
fn phase_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    names.add(match scene.law.facts().carries_time {
        true if choice.follows_shift(scene) => "law/phase_stretched",
        true => "law/phase_spacetime",
        false => "law/phase_space",
    });
    names.add(scene.rays.control.kind.memory);
}

fn end_parts(scene: &Scene, choice: &Choice, names: &mut Names) -> Result<(), ProgramError> {
    let captures = scene.captures(None);
    let by_formula = scene.law.facts().line_element().is_some_and(|element| element.graph().4.is_some());
    names.add(match captures.is_empty() {
        _ if by_formula => "law/capture_formula",
        true => "law/capture_none",
        false => scene.law.facts().capture_part.unwrap_or("law/capture_spheres"),
    });
    let anchors = captures.iter().map(|capture| capture.anchor).chain(scene.law.facts().anchors);
    let anchors: Vec<_> = anchors.map(|anchor| anchor.kind).collect();
    let kinds: Vec<_> = ANCHORS.into_iter().filter(|kind| anchors.contains(kind)).collect();
    names.wgsl(kinds.iter().map(|kind| kind.part()))?;
    if !kinds.is_empty() {
        names.make(generated::anchors(&kinds));
    }
    names.add(if scene.rays.length.is_some() { "law/limit_length" } else { "law/limit_none" });
    let summed = scene.rays.length.is_some() && scene.rays.precision != Precision::Double;
    names.add(if summed { "state/tau_compensated" } else { "state/tau_plain" });
    names.add(if scene.rays.asymptotic { "law/asymptotic_orbit" } else { "law/asymptotic_none" });
    let hits = !scene.objects.is_empty();
    let stepped = ends_with_steps(scene);
    names.add(if stepped { "segment/path_end_stepped" } else { "segment/path_end" });
    match scene.rays.segment {
        Segment::Arc { .. } => {
            names.all(&["segment/follow_step", "segment/quick_same"]);
            let kept = stepped && choice.schedule == Schedule::Whole;
            names.add(if kept { "segment/last_kept" } else { "segment/last_retaken" });
            names.all(match hits {
                true if scene.travels().next().is_some() => &["segment/end_on_moving"],
                true => &["segment/end_on_arc"],
                false => &["segment/end_open", "segment/stop_open"],
            });
        }
        Segment::Chord { steps } => {
            let planned = !scene.rays.control.kind.rejects && scene.rays.method.kind.path == Path::Steps;
            if planned && steps <= WRITTEN_OUT {
                names.add("segment/quick_chord");
                names.make(generated::chord(steps));
            } else {
                names.add("segment/quick_same");
            }
            names.all(&["segment/follow_chord", "segment/stop_open"]);
            names.add(if hits { "segment/end_on_chord" } else { "segment/end_open" });
        }
    }
    Ok(())
}

fn surface_parts(scene: &Scene, choice: &Choice, suspends: bool, analysis: &Analysis, names: &mut Names) {
    let all = solids(scene.objects.iter());
    if all.is_empty() {
        names.all(&["segment/no_surfaces"]);
        return;
    }
    let Analysis { regions, structure } = analysis;
    names.all(&["segment/pieces", "segment/hits", "shape/placed"]);
    names.all(match (suspends, choice.schedule) {
        (false, _) => &["segment/walk_in_one", "segment/walk_whole"],
        (true, Schedule::Whole) => &["segment/walk_in_one", "segment/walk_once"],
        (true, _) => &["segment/walk_resumed"],
    });
    let leaps = regions.kinds.iter().any(|kind| kind.leaps);
    let moving = solids(scene.travels().map(|(_, object, _)| object));
    names.add(match leaps {
        _ if !moving.is_empty() => "segment/hit_moving",
        true => "segment/hit_leaping",
        false => "segment/hit_direct",
    });
    if !moving.is_empty() {
        names.add("shape/moving");
    }
    names.each("shape", all.iter().map(|solid| solid.name));
    if structure.once {
        names.add("shape/instance");
    }
    let with_side = |side: bool| {
        let still = scene.objects.iter().enumerate().filter(|(_, object)| object.travel.is_none());
        let objects = still.filter(move |(i, _)| regions.bit(*i).is_some() == side);
        solids(objects.map(|(_, object)| object))
    };
    let (mut listed, mut sided) = (with_side(false), with_side(true));
    // One search meets all triangles, whatever their objects are made of.
    sided.retain(|solid| solid.lists.is_some());
    listed.retain(|solid| !structure.holds(solid));
    names.add(if structure.near { "segment/near_balls" } else { "segment/near_all" });
    names.add(match (listed.is_empty() && sided.is_empty(), structure.near) {
        (true, _) => "segment/lists_none",
        (false, true) => "segment/lists_near",
        (false, false) => "segment/lists_some",
    });
    if structure.solids.is_empty() {
        names.add("segment/structure/none");
    } else {
        names.add("segment/pieces");
        names.add(structure.order());
        names.each("segment/structure", structure.parts().iter().copied());
    }
    names.make(generated::shapes(analysis, &all, &moving));
    names.make(if structure.near {
        generated::near(scene, analysis, &listed, &sided)
    } else {
        generated::lists(scene, analysis, &listed, &sided)
    });
    names.add("surface/seen");
}
