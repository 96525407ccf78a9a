//! Choice of the modules for images: the sample positions, the camera, the seen light and its processing.

use super::names::Names;
use super::skies::two_skies;
use super::{Features, ProgramError, generated};
use crate::model::Pattern;
use crate::model::material::SurfaceProperties;
use crate::program::Layer;
use crate::scene::{SamplePattern, Scene, Shadows};

pub(super) fn camera_parts(scene: &Scene, features: &Features, names: &mut Names) {
    if let Some(part) = features.below_part {
        names.all(&[part]);
        names.all(scene.law.facts().momentum_parts);
    }
    names.add("camera/arrival");
    if features.mode.is_given() {
        names.add("camera/given");
        return;
    }
    names.all(&["camera/sample/point", "camera/view"]);
    match scene.image.sampler {
        _ if scene.image.samples == 1 => names.add("camera/sample/center"),
        SamplePattern::MultiJittered => names.add("camera/sample/multi_jittered"),
        SamplePattern::Progressive => names.add("camera/sample/sobol"),
    }
    names.all(if features.follows_paths {
        &["camera/sample/seeded", "path/transport"]
    } else {
        &["camera/sample/unseeded"]
    });
    // A scene that is only traced is validated with a default camera.
    let camera = scene.camera.as_ref();
    names.add(camera.map_or("camera/pinhole", |camera| camera.projection.part()));
    let frame = camera.and_then(|camera| scene.law.frame_part(camera.observer));
    names.add(frame.unwrap_or("camera/frame_coordinate"));
    if let Some((camera, stereo)) = camera.and_then(|camera| Some((camera, camera.stereo?))) {
        let crosses = stereo.convergence.is_some();
        names.add(if crosses { camera.projection.convergence_part() } else { "camera/eyes/parallel" });
    }
}

/// Adds the modules that process the light.
pub(super) fn picture_parts(scene: &Scene, features: &Features, names: &mut Names) -> Result<(), ProgramError> {
    names.when(features.keeps_crossings, &["segment/crossings"]);
    names.when(features.is_picture() || features.knows_shift, &[shift_part(features)]);
    names.when(features.knows_shift, scene.law.facts().momentum_parts);
    if features.is_picture() || features.volumes.is_spectral {
        sky_parts(scene, names)?;
    }
    if !features.is_picture() {
        return Ok(());
    }
    names.when(features.keeps_orders, &["picture/orders_kept"]);
    let bundles = ["picture/bundle/grid", "picture/bundle/footprint", bundle_part(features)];
    names.when(features.has_grid || features.keeps_footprints, &bundles);
    names.when(features.has_grid, &["picture/bundle/measured", "picture/bundle/layers"]);
    names.when(features.has_stars, &STARS);
    names.when(features.layers.contains(&Layer::Depth), &["picture/path_length"]);
    let layers = features
        .layers
        .iter()
        .filter(|layer| layer.is_of_a_ray() && !layer.is_of_crossings() && !layer.is_of_bundles())
        .map(|layer| layer.name());
    names.make(generated::layers(&layers.collect::<Vec<_>>()));
    Ok(())
}

/// The modules for stars.
const STARS: [&str; 8] = [
    "picture/stars/ray",
    "picture/stars/patch",
    "picture/stars/buckets",
    "picture/stars/search",
    "picture/stars/light",
    "picture/stars/cell",
    "picture/stars/image",
    "picture/stars/work",
];

/// Adds the modules for the light of the sky.
fn sky_parts(scene: &Scene, names: &mut Names) -> Result<(), ProgramError> {
    match &scene.sky_other_side {
        Some(beyond) => {
            names.add("picture/sky/both");
            for unit in two_skies(scene.sky.part(), beyond.part())? {
                names.make(unit);
            }
        }
        None => names.add(scene.sky.part()),
    }
    Ok(())
}

/// Returns the module for the redshift.
fn shift_part(features: &Features) -> &'static str {
    if features.follows_shift { "picture/shift_in_time" } else { "picture/shift" }
}

/// Returns the module with the bundles of light of pixels.
fn bundle_part(features: &Features) -> &'static str {
    if features.shades_ends() { "picture/bundle/stored" } else { "picture/bundle/kept" }
}

/// Returns the module that selects the pixels that take a sample, and stores values at their corners.
pub(super) fn samples_part(features: &Features) -> &'static str {
    if features.adapts { "picture/adaptive" } else { "picture/samples" }
}

/// Adds the modules for the appearance of surfaces.
pub(super) fn material_parts(scene: &Scene, features: &Features, names: &mut Names) {
    if features.has_images {
        names.make(generated::images(scene.pictures.len()));
    }
    if !features.has_objects {
        return;
    }
    let used = || scene.used_materials();
    let ends = || used().filter(|material| !material.surface.facts().continues);
    let mut kinds: Vec<&str> = ends().map(|material| material.surface.facts().part).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let is_used = |part: &str, has_vertex_colors: bool| {
        used().any(|material| (material.color.part(), material.color.has_vertex_colors()) == (part, has_vertex_colors))
    };
    let patterns = Pattern::PARTS.into_iter().flat_map(|part| [(part, false), (part, true)]);
    let patterns: Vec<(&str, bool)> =
        patterns.filter(|(part, has_vertex_colors)| is_used(part, *has_vertex_colors)).collect();
    let lights = [
        ("point", scene.lights.iter().any(|light| light.is_point() && !light.shadows.follows_the_law())),
        ("directional", scene.lights.iter().any(|light| !light.is_point() && !light.shadows.follows_the_law())),
        ("shot", scene.lights.iter().any(|light| light.shadows == Shadows::Shooting)),
        ("grid", scene.lights.iter().any(|light| light.shadows == Shadows::Grid)),
    ];
    let lights: Vec<&str> =
        lights.into_iter().filter(|(_, there)| *there && features.is_lit).map(|(name, _)| name).collect();
    names.add("surface/material");
    names.all(&kinds);
    names.add("surface/pattern");
    names.each("surface/light", lights.iter().copied());
    let parts_of = |wanted: fn(&SurfaceProperties) -> bool| -> Vec<&str> {
        ends()
            .filter(|material| wanted(&material.surface.facts()))
            .map(|material| material.surface.facts().part)
            .collect()
    };
    let tempered = parts_of(|surface| surface.has_temperature);
    names.make(generated::materials(&generated::Answers {
        kinds: &kinds,
        tempered: &tempered,
        orbiting: &parts_of(|surface| surface.orbits),
        patterns: &patterns,
        lights: &lights,
        paths: features.follows_paths,
        shift: features.knows_shift && !features.follows_shift,
        beaming: features.beams,
    }));
}
