//! The plan: which parts a scene is made of. One file per contract; the cheapest that is right for the scene.

use super::link::Parts;
use super::names::Names;
use super::picture_parts::{camera_parts, material_parts, picture_parts};
use super::region_parts::region_parts;
use super::regions::{RegionKind, Regions};
use super::structure::solids;
use super::{Analysis, Choice, Masks, Pass, ProgramError, Purpose, Work, generated};
use crate::model::Material;
use crate::model::source::SOURCES;
use crate::scene::{Branches, Precision, Scene, Segment};

/// The parts of `scene`'s program. Parts of a contract that a pass does not call are left out when it is linked.
pub fn plan(scene: &Scene, analysis: &Analysis, choice: &Choice, work: &Work) -> Result<Parts, ProgramError> {
    let mut names = Names::default();
    names.all(&[
        "ray",
        "frame",
        "work",
        "bound",
        "schedule",
        "turn",
        "math",
        "tally/totals",
        "fate",
        "path_end",
        "colors",
    ]);
    names.all(&["state/ray", "living/place", "stage/ended", "stage/between", "stage/advanced"]);
    names.all(match scene.rays.precision {
        Precision::Half => &["real/f32", "state/texture", "state/texels_f16"],
        Precision::Single => &["real/f32", "state/texture", "state/texels_f32"],
        Precision::Double => &["real/f64", "state/buffer"],
    });
    let regions = &analysis.regions;
    names.make(generated::counts(scene, regions));
    phase_parts(scene, &mut names);
    scatter_parts(scene, choice, regions, &mut names);
    let pass_part =
        |pass: &Pass| if *pass == Pass::Advance && choice.masks == Masks::Off { "advance_all" } else { pass.entry() };
    names.each("pass", choice.passes(scene).iter().map(pass_part));
    schedule_parts(scene, choice, regions, &mut names);
    camera_parts(scene, choice, &mut names);
    end_parts(scene, &mut names);
    surface_parts(scene, choice, work, analysis, &mut names);
    if choice.purpose == Purpose::Picture {
        picture_parts(scene, choice, &mut names);
    }
    if !scene.pictures.is_empty() {
        names.add("image_sample");
        names.make(generated::images(scene.pictures.len()));
    }
    if !scene.objects.is_empty() {
        material_parts(scene, &mut names);
    }
    let of_kind = |kind: &RegionKind| region_parts(scene, choice.purpose, regions, kind);
    Ok(Parts { shared: names.units()?, regions: regions.kinds.iter().map(of_kind).collect::<Result<_, _>>()? })
}

fn schedule_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    names.add(match choice.masks {
        Masks::Off => "living/all",
        Masks::Grid => "living/grid",
        Masks::List => "living/list",
    });
    names.add(match (choice.lists_open(scene), choice.rounds(scene) > 1) {
        (false, _) => "round/once",
        (true, false) => "round/chosen",
        (true, true) => "round/open",
    });
    names.add(if choice.adapts(scene) { "wanted/open" } else { "wanted/all" });
    names.add(if choice.slots(scene) == 3 { "slots/three" } else { "slots/two" });
    names.add(if choice.keeps_counts() { "counts/kept" } else { "counts/none" });
    names.add(if scene.rays.control.kind.tries.is_some() { "tally/rejections" } else { "tally/no_rejections" });
    names.add(if keeps_taken(scene, regions) { "stage/taken_kept" } else { "stage/taken_none" });
}

/// Arcs that are not straight need their step's size in the pass that intersects them.
fn keeps_taken(scene: &Scene, regions: &Regions) -> bool {
    let arcs = !scene.rays.segment.has_chords() && !regions.kinds.iter().all(RegionKind::is_line);
    arcs && !scene.objects.is_empty()
}

/// What a state is, and what the control remembers of it.
fn phase_parts(scene: &Scene, names: &mut Names) {
    names.add(if scene.law.carries_time() { "phase/spacetime" } else { "phase/space" });
    names.add(scene.rays.control.kind.memory);
}

/// Which medium a ray is in, and what becomes of it at surfaces that it goes on from.
fn scatter_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    names.add("stride/turn");
    if !scene.scatters() {
        names.all(&["region/none", "scatter/none", "weight/none", "branch/transmitted", "left/none", "facing/any"]);
        return;
    }
    let continuing = || scene.objects.iter().enumerate().filter(|(_, object)| scene.continues_from(object));
    let flat = continuing().any(|(i, _)| regions.bit(i).is_none());
    let sided_mesh = regions.regions.iter().any(|region| scene.objects[region.object].shape.mesh().is_some());
    names.all(&["scatter/some", "scatter/scattered", "branch/branch"]);
    names.add(if regions.regions.is_empty() { "region/none" } else { "region/set" });
    names.add(if choice.purpose == Purpose::Trace { "origin/given" } else { "origin/camera" });
    names.add(if flat { "left/kept" } else { "left/none" });
    names.add(if sided_mesh { "facing/sided" } else { "facing/any" });
    names.add(if regions.touching.count() > 0 { "touching/some" } else { "touching/none" });
    let is_gray = |material: &Material| !material.surface.continues() || material.color.is_gray();
    let kept = if scene.materials.iter().all(is_gray) { "weight/gray" } else { "weight/colored" };
    let (weight, branch) = match (choice.purpose, scene.rays.branches) {
        (Purpose::Picture, Branches::Enumerated(_)) => (kept, "branch/enumerated"),
        (Purpose::Picture, Branches::Random) => (kept, "branch/random"),
        _ => ("weight/none", "branch/transmitted"),
    };
    names.all(&[weight, branch]);
    let mut kinds: Vec<&str> = continuing().filter_map(|(_, o)| Some(scene.material_of(o)?.surface.part())).collect();
    if scene.splits() {
        names.add("scatter/refraction");
        kinds.push("scatter/clear");
    }
    kinds.sort_unstable();
    kinds.dedup();
    names.all(&kinds);
    names.make(generated::scatter(&kinds));
    names.make(generated::regions(regions));
}

fn end_parts(scene: &Scene, names: &mut Names) {
    let captures = scene.captures(None);
    names.add(if captures.is_empty() { "capture/none" } else { "capture/spheres" });
    let anchors = captures.iter().map(|capture| capture.anchor).chain(scene.law.anchors());
    let anchors: Vec<_> = anchors.map(|anchor| anchor.kind).collect();
    let kinds: Vec<_> = SOURCES.into_iter().filter(|kind| anchors.contains(kind)).collect();
    names.wgsl(kinds.iter().map(|kind| kind.part()));
    if !kinds.is_empty() {
        names.make(generated::anchors(&kinds));
    }
    names.add(if scene.rays.length.is_some() { "limit/length" } else { "limit/none" });
    names.add(if scene.rays.asymptotic { "asymptotic/orbit" } else { "asymptotic/none" });
    let hits = !scene.objects.is_empty();
    match scene.rays.segment {
        Segment::Arc { .. } => {
            names.all(&["follow/step", if hits { "stage/end_on_arc" } else { "stage/end_open" }]);
        }
        Segment::Chord { .. } => {
            names.all(&["follow/steps", if hits { "stage/end_on_chord" } else { "stage/end_open" }]);
        }
    }
}

fn surface_parts(scene: &Scene, choice: &Choice, work: &Work, analysis: &Analysis, names: &mut Names) {
    let recorded = choice.purpose != Purpose::Picture;
    let all = solids(scene.objects.iter());
    if all.is_empty() {
        names.all(&["walk/none", "stage/seen_nothing"]);
        names.add(if recorded { "stage/recorded_nothing" } else { "stage/seen" });
        return;
    }
    let Analysis { regions, structure } = analysis;
    names.all(&["walk/piece", "hits", "shape/placed"]);
    names.add(if work.resumed { "walk/resumed" } else { "walk/whole" });
    let leaps = regions.kinds.iter().any(|kind| kind.leaps);
    names.add(if leaps { "walk/leaping" } else { "walk/direct" });
    names.each("shape", all.iter().map(|solid| solid.name));
    let with_side = |side: bool| {
        let objects = scene.objects.iter().enumerate().filter(move |(i, _)| regions.bit(*i).is_some() == side);
        solids(objects.map(|(_, object)| object))
    };
    let (mut listed, mut sided) = (with_side(false), with_side(true));
    // One search meets all triangles, whatever their objects are made of.
    sided.retain(|solid| solid.lists.is_some());
    listed.retain(|solid| !structure.holds(solid));
    names.add(if listed.is_empty() && sided.is_empty() { "listed/none" } else { "listed/some" });
    if structure.solids.is_empty() {
        names.add("structure/none");
    } else {
        names.add("walk/items");
        names.add(if structure.in_order() { "order/same" } else { "order/listed" });
        names.each("structure", [structure.search.name()]);
    }
    let sided_mesh = regions.regions.iter().any(|region| scene.objects[region.object].shape.mesh().is_some());
    if !sided.is_empty() || sided_mesh {
        names.add("crossing/crossing");
        names.each("crossing", sided.iter().map(|solid| solid.name));
    }
    names.make(generated::shapes(scene, analysis, &all, &listed, &sided));
    if recorded {
        names.add("stage/recorded_surface");
    } else {
        names.all(&["stage/seen", "stage/seen_surface"]);
    }
}
