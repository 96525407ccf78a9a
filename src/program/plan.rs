//! The plan: the modules of a scene's program. It has one file per contract, the cheapest that is correct for the scene, and the files
//! without alternatives; code that a pass does not reach is dropped by the linker.

use super::matter::matter_parts;
use super::names::Names;
use super::onward_parts::scatter_parts;
use super::picture_parts::{camera_parts, material_parts, picture_parts, samples_part};
use super::region_parts::region_parts;
use super::regions::RegionKind;
use super::structure::solids;
use super::unit::Parts;
use super::{Analysis, Features, PathEnds, ProgramError, RaySkipping, generated, short_lists};
use crate::model::point_source::ANCHORS;
use crate::scene::{Precision, Scene, Segment};

/// Chooses the modules of `scene`'s program. Modules of a contract that a pass does not call are dropped by the linker.
///
/// # Errors
///
/// Returns an error if a module does not exist, or the WGSL of the scene is invalid.
pub fn plan(scene: &Scene, analysis: &Analysis, features: &Features) -> Result<Parts, ProgramError> {
    let Analysis { regions, .. } = analysis;
    let mut names = Names::default();
    names.all(&[
        "camera/pixels",
        "camera/ray",
        "camera/sample/scrambled",
        "law/asymptotic",
        "law/bound",
        "law/limit",
        "picture/beaming",
        "picture/coverage",
        "picture/layers",
        "picture/shade",
        "picture/spread",
        "real/hash",
        "shape/facing",
        "surface/black_body",
        "surface/branch",
        "surface/image",
        "surface/light/field",
        "surface/occlusion",
        "surface/scatter/lobe",
        "surface/shadow/clear",
        "surface/shadow/look",
        "surface/vertex_colors",
        "surface/throughput/finite",
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
        "state/ray",
        "state/active",
        "state/finish",
        "segment/last_hit",
        "segment/quick",
        "segment/follow",
        "segment/hits",
        "segment/lists",
        "segment/pieces",
        "segment/walk",
        "shape/placed",
        "surface/seen",
        "segment/stop",
        "state/counts",
        "state/loops",
        "state/tau",
    ]);
    names.add(if features.shades_ends() { "segment/stored_end" } else { "segment/path_end" });
    names.when(features.ends != PathEnds::Followed, &["state/ends"]);
    names.make(features.unit());
    names.make(generated::loop_budget(features.device.loop_budget));
    names.make(generated::counts(scene, features, regions));
    names.all(if features.precision == Precision::Double {
        &["real/f64", "state/buffer"]
    } else {
        &["real/f32", "state/texture"]
    });
    names.make(generated::texels(features.precision));
    names.add(if scene.rays.control.kind.remembers { "method/memory_pair" } else { "method/memory_step" });
    names.each("pass", features.passes().iter().map(|pass| pass.entry()));
    scatter_parts(scene, features, regions, &mut names);
    schedule_parts(features, &mut names);
    camera_parts(scene, features, &mut names);
    law_parts(scene, &mut names);
    if let Segment::Chord { steps } = scene.rays.segment
        && features.writes_chords_out
    {
        names.make(generated::chord(steps));
    }
    surface_parts(scene, features, analysis, &mut names);
    picture_parts(scene, features, &mut names)?;
    material_parts(scene, features, &mut names);
    shadow_parts(features, &mut names);
    let wavelength = if features.draws_wavelength { "path/spectrum" } else { "medium/wavelength" };
    names.when(features.disperses, &[wavelength]);
    matter_parts(scene, features, &mut names);
    let of_kind = |kind: &RegionKind| region_parts(scene, features, regions, kind);
    Ok(Parts {
        shared: names.units()?,
        regions: regions.kinds.iter().map(of_kind).collect::<Result<_, _>>()?,
        lengths: short_lists::lengths(scene, regions),
        device: features.device,
    })
}

/// Adds the modules for shadows and for ambient occlusion.
fn shadow_parts(features: &Features, names: &mut Names) {
    names.add(if features.weakens_lines { "surface/shadow/filtered" } else { "surface/shadow/straight" });
    let shot = if features.is_plane { "surface/shot/planar" } else { "surface/shot/newton" };
    names.when(features.shoots, &["surface/shot/shot", shot]);
    names.when(features.has_rough_glass, &["surface/scatter/frosted", "surface/scatter/microfacet"]);
}

fn schedule_parts(features: &Features, names: &mut Names) {
    names.all(&[
        if features.masks == RaySkipping::List { "state/active/list" } else { "state/active/grid" },
        "state/round",
        samples_part(features),
    ]);
    names.all(match features.masks {
        _ if features.mode.leaves_light() => &["segment/run_active", "segment/leave_light"],
        RaySkipping::Off => &["segment/run_all"],
        RaySkipping::Grid | RaySkipping::List => &["segment/run_active"],
    });
}

/// Adds the modules for the state of rays, their possible paths and their ends.
fn law_parts(scene: &Scene, names: &mut Names) {
    let captures = scene.captures(None);
    let facts = scene.law.facts();
    names.all(&[if facts.carries_time { "law/phase_spacetime" } else { "law/phase_space" }, "law/capture"]);
    let anchors = captures.iter().map(|capture| capture.anchor).chain(facts.anchors.iter().copied());
    let anchors: Vec<_> = anchors.map(|anchor| anchor.kind).collect();
    let kinds: Vec<_> = ANCHORS.into_iter().filter(|kind| anchors.contains(kind)).collect();
    if !kinds.is_empty() {
        names.add("law/offset");
        names.make(generated::anchors(&kinds));
    }
}

fn surface_parts(scene: &Scene, features: &Features, analysis: &Analysis, names: &mut Names) {
    let all = solids(scene.objects.iter());
    let moving = solids(scene.travels().map(|(_, object, _)| object));
    if moving.is_empty() {
        names.add("segment/hit_still");
    } else {
        names.all(&["segment/hit_moving", "shape/moving"]);
    }
    if all.is_empty() {
        return;
    }
    let Analysis { regions, structure } = analysis;
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
    // One search finds all triangles, whatever the materials of their objects.
    sided.retain(|solid| solid.lists.is_some());
    listed.retain(|solid| !structure.holds(solid));
    names.when(structure.near, &["segment/near_balls"]);
    if features.has_structure {
        names.add(structure.order());
        names.each("segment/structure", structure.parts().iter().copied());
    }
    names.make(generated::shapes(analysis, &all, &moving));
    names.make(if structure.near {
        generated::near(scene, analysis, (&listed, &sided), features.device.is_processor)
    } else {
        generated::lists(scene, analysis, &listed, &sided)
    });
}
