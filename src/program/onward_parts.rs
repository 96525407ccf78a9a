//! Choice of the modules for events along rays: scattering at surfaces.

use super::names::Names;
use super::regions::Regions;
use super::{Features, Mode, formula, generated};
use crate::model::{Gloss, Material};
use crate::scene::Scene;

/// Adds the modules for the medium of a ray, and for scattering at surfaces.
pub(super) fn scatter_parts(scene: &Scene, features: &Features, regions: &Regions, names: &mut Names) {
    if !features.scatters {
        names.all(&["surface/region_none", "surface/scatter/none"]);
        names.add(plain_throughput(scene, features));
        return;
    }
    let &Features { follows_paths, in_pieces, is_translucent, has_regions, .. } = features;
    let continuing = || scene.objects.iter().enumerate().filter(|(_, object)| scene.continues_from(object));
    names.all(&[
        "surface/scatter/scattered",
        if has_regions { "surface/region_set" } else { "surface/region_none" },
        "surface/shared_surfaces",
    ]);
    names.when(in_pieces, &["segment/pass_top", "path/aside"]);
    if follows_paths {
        path_parts(scene, features, names);
    } else {
        names.add("surface/scatter/some");
        sent_parts(scene, features, names);
    }
    let fans: Vec<_> = scene.fans().into_iter().map(|(_, rays)| rays).collect();
    if !fans.is_empty() {
        names.make(formula::fans(&fans));
        // Media given by formulas have their own copy, which is called instead.
        if scene.media().all(|medium| medium.facts().formula.is_none()) {
            names.add("medium/formula");
        }
    }
    let mut kinds: Vec<&str> =
        continuing().filter_map(|(_, o)| Some(scene.material_of(o)?.surface.facts().part)).collect();
    kinds.extend(scene.glosses().map(Gloss::part));
    kinds.sort_unstable();
    kinds.dedup();
    // The module that splits light at any of these surfaces.
    let smooth = features.splits.then_some("surface/scatter/transmissive");
    let mut parts: Vec<&str> = kinds.iter().copied().chain(smooth).collect();
    parts.sort_unstable();
    names.all(&parts);
    let ends = scene.objects.iter().any(|object| object.interior().is_none() && !scene.continues_from(object));
    names.when(is_translucent, &["surface/scatter/translucent"]);
    names.make(generated::scatter(&kinds, ends.then_some(is_translucent)));
    names.make(generated::regions(regions));
}

/// Adds the modules for the throughput of a path, and for its continuation.
fn path_parts(scene: &Scene, features: &Features, names: &mut Names) {
    let aims = scene.aims();
    names.all(&[
        "path/carried",
        "path/random",
        "path/vertex",
        "path/scatter",
        "path/light_sampling/flight",
        "path/bsdf",
    ]);
    names.when(features.clamps, &["picture/clamped"]);
    if !aims.is_empty() {
        names.each("path/light_sampling", aims.iter().copied());
        names.make(generated::aims(&aims, scene.beams().len()));
    }
}

/// Adds the modules for the throughput of scattered rays, and for the choice between two branches.
fn sent_parts(scene: &Scene, features: &Features, names: &mut Names) {
    let is_colored = |material: &Material| material.surface.facts().continues && !material.color.is_gray();
    let plain = plain_throughput(scene, features);
    let has_colors = features.is_picture() && !features.volumes.is_spectral;
    names.add(match plain {
        "surface/throughput/none" | "surface/throughput/single" if has_colors => {
            if scene.materials.iter().any(is_colored) {
                "surface/throughput/colored"
            } else {
                "surface/throughput/single"
            }
        }
        _ => plain,
    });
}

/// Returns the module for the throughput of a ray before any surface has changed it.
fn plain_throughput(scene: &Scene, features: &Features) -> &'static str {
    match features.mode {
        Mode::Light | Mode::Caustics => "surface/throughput/single",
        _ if features.volumes.is_spectral && features.volumes.counts_transfer => "surface/throughput/single",
        Mode::Picture if features.sees_glow => "path/carried",
        Mode::Picture if features.volumes.absorbs && !features.volumes.is_spectral => "surface/throughput/colored",
        // L/n² is constant along a ray.
        Mode::Picture if !features.volumes.is_spectral && scene.law.facts().medium().is_some() => {
            "surface/throughput/single"
        }
        _ => "surface/throughput/none",
    }
}
