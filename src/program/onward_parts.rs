//! The parts of what becomes of a ray on its way: at surfaces that it goes on from, and in media that filter its light.

use super::names::Names;
use super::region_parts::joins_whole;
use super::regions::Regions;
use super::{Choice, Purpose, formula, generated};
use crate::model::{Filter, Gloss, Material};
use crate::scene::{Branches, Scene};

/// What media take from light on its way.
pub(super) fn filter_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    names.add("filter/along");
    names.add(if regions.regions.is_empty() { "filter/place_space" } else { "filter/place_regions" });
    names.add(if choice.sees_glow(scene) { "filter/glowing" } else { "filter/dark" });
    let lines = choice.purpose == Purpose::Picture && scene.weakens_lines();
    names.add(if lines { "filter/track/line" } else { "filter/track/path" });
    let mut kinds: Vec<&str> = scene.filters().map(Filter::part).collect();
    // Where there is none it is even.
    kinds.push("even");
    kinds.sort_unstable();
    kinds.dedup();
    names.each("filter", kinds.iter().copied());
    names.add(if kinds.contains(&"texture/wrapped") { "filter/jumping" } else { "filter/smooth" });
    if scene.filters().any(|filter| filter.texture().is_some()) {
        names.all(&["filter/texture/noise", "medium/fractal_noise"]);
    }
    let formulas: Vec<_> = scene.filters().filter_map(Filter::formulas).collect();
    if !formulas.is_empty() {
        names.make(formula::filters(&formulas));
        names.add("medium/formula");
    }
    names.make(generated::filters(&kinds));
}

/// Which medium a ray is in, and what becomes of it at surfaces that it goes on from.
pub(super) fn scatter_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    if !scene.scatters() {
        names.all(&[
            "surface/region_none",
            "surface/scatter/none",
            "surface/branch/transmitted",
            "segment/last_hit_none",
            "shape/facing_any",
        ]);
        weight_parts(plain_weight(scene, choice), names);
        return;
    }
    let paths = choice.follows_paths(scene);
    let continuing = || scene.objects.iter().enumerate().filter(|(_, object)| scene.continues_from(object));
    let translucent = scene.has_translucent();
    let flat = translucent || continuing().any(|(i, _)| regions.bit(i).is_none());
    let sided_mesh = regions.regions.iter().any(|region| scene.objects[region.object].shape.mesh().is_some());
    names.add("surface/scatter/scattered");
    if paths {
        path_parts(scene, choice, names);
    } else {
        names.add("surface/scatter/some");
    }
    names.add(if regions.regions.is_empty() { "surface/region_none" } else { "surface/region_set" });
    names.add(if choice.purpose.is_given() { "surface/origin_given" } else { "surface/origin_camera" });
    // Paths that are in pieces are told where they left a surface.
    let in_pieces = paths && !regions.kinds.iter().all(|kind| joins_whole(scene, kind));
    if in_pieces {
        names.all(&["segment/pass_top", "path/aside"]);
    }
    names.add(if flat || in_pieces { "segment/last_hit_kept" } else { "segment/last_hit_none" });
    names.add(if sided_mesh { "shape/facing_sided" } else { "shape/facing_any" });
    let fans: Vec<_> = scene.fans().into_iter().map(|(_, rays)| rays).collect();
    let closed_fan = !fans.is_empty() && !regions.regions.is_empty();
    if sided_mesh || closed_fan {
        names.add("shape/object_bits");
    }
    if !fans.is_empty() {
        names.add(if closed_fan { "surface/through/closed" } else { "surface/through/open" });
        names.make(formula::fans(&fans));
        // Media that are formulas have a copy of their own, which is called then.
        if scene.media().all(|medium| medium.formula().is_none()) {
            names.add("medium/formula");
        }
    }
    names.add(if regions.touching.count() > 0 { "surface/touching_some" } else { "surface/touching_none" });
    if !paths {
        sent_parts(scene, choice, names);
    }
    let mut kinds: Vec<&str> = continuing().filter_map(|(_, o)| Some(scene.material_of(o)?.surface.part())).collect();
    kinds.extend(scene.glosses().map(Gloss::part));
    if scene.has_lobes() {
        names.add("surface/scatter/lobe");
        names.add(match choice.purpose {
            Purpose::Picture if paths => "path/lobe",
            Purpose::Picture | Purpose::Light | Purpose::Caustics => "surface/scatter/lobe_random",
            _ => "surface/scatter/lobe_axis",
        });
        names.add("camera/sample/scrambled");
    }
    kinds.sort_unstable();
    kinds.dedup();
    // What splits light at any of them.
    let smooth = scene.splits().then_some("surface/scatter/transmissive");
    let mut parts: Vec<&str> = kinds.iter().copied().chain(smooth).collect();
    parts.sort_unstable();
    names.all(&parts);
    let ends = scene.objects.iter().any(|object| object.interior().is_none() && !scene.continues_from(object));
    if translucent {
        let enumerated = choice.purpose == Purpose::Picture && matches!(scene.rays.branches, Branches::Enumerated(_));
        names.add("surface/scatter/translucent");
        names.add(if enumerated { "surface/branch/settled_kept" } else { "surface/branch/settled_again" });
    }
    names.make(generated::scatter(&kinds, ends.then_some(translucent)));
    names.make(generated::regions(regions));
}

/// What a path carries, and how it goes on.
fn path_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    names.all(&["path/carried", "path/random", "path/branch", "path/vertex", "path/scatter", "surface/scatter/lobe"]);
    names.add("camera/sample/scrambled");
    let glossy = scene.used_materials().any(|material| material.surface.is_glossy());
    names.add(if glossy { "path/answer/glossy" } else { "path/answer/matte" });
    let aims = scene.aims();
    names.add(if aims.is_empty() { "path/aim/none" } else { "path/aim/flight" });
    if !aims.is_empty() {
        names.each("path/aim", aims.iter().copied());
        names.make(generated::aims(&aims, scene.beams().len()));
    }
    if aims.contains(&"guide") {
        names.add("surface/light/field");
    }
    names.add(if choice.adapts(scene) { "picture/spread_none" } else { "picture/spread_kept" });
    if scene.output.clamp.is_some() {
        names.add("picture/clamped");
    }
}

/// What is sent on counts for so much, and which ray of two it is.
fn sent_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    let is_gray = |material: &Material| !material.surface.continues() || material.color.is_gray();
    let kept = match plain_weight(scene, choice) {
        "surface/weight/none" if scene.materials.iter().all(is_gray) => GRAY,
        "surface/weight/none" => "surface/weight/colored",
        filtered => filtered,
    };
    let (weight, branch) = match (choice.purpose, scene.rays.branches) {
        (Purpose::Picture, Branches::Enumerated(_)) => (kept, "surface/branch/enumerated"),
        (Purpose::Picture, Branches::Random) => (kept, "surface/branch/random"),
        (Purpose::Light | Purpose::Caustics, _) => (plain_weight(scene, choice), "surface/branch/random"),
        _ => ("surface/weight/none", "surface/branch/transmitted"),
    };
    weight_parts(weight, names);
    names.add(branch);
}

/// What is known of a ray's weight where no surface has changed it.
fn plain_weight(scene: &Scene, choice: &Choice) -> &'static str {
    match choice.purpose {
        Purpose::Light => LIGHT,
        Purpose::Caustics => CAUSTIC,
        Purpose::Picture if choice.sees_glow(scene) => "path/carried",
        Purpose::Picture if choice.filters(scene) => "surface/weight/colored",
        _ => "surface/weight/none",
    }
}

const GRAY: &str = "surface/weight/gray";
const LIGHT: &str = "surface/weight/light";
const CAUSTIC: &str = "surface/weight/caustic";

/// A weight, and how it is kept.
fn weight_parts(weight: &'static str, names: &mut Names) {
    names.add(weight);
    if matches!(weight, GRAY | LIGHT | CAUSTIC) {
        names.add("surface/weight/kept_single");
    }
}
