//! The parts of pictures: where samples lie, the camera, what is seen, and what is made of it.

use super::names::Names;
use super::skies::two_skies;
use super::{Choice, Layer, ProgramError, Purpose, generated};
use crate::model::{Pattern, Projection, Stereo, StereoLayout, Surface};
use crate::scene::{Animation, Light, Precision, SamplePattern, Scene, Shadows, Sky, Tonemap};

pub(super) fn camera_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    // A film has one program for all places that its camera comes to.
    let moves = |animation: &Animation| {
        animation.keys.iter().any(|key| ["camera.position", "camera.proper_time"].contains(&&**key))
    };
    let is_anywhere = choice.purpose.is_given() || scene.animation.as_ref().is_some_and(moves);
    let eye = scene.camera.as_ref().filter(|_| !is_anywhere).map(|camera| camera.position);
    let facts = scene.law.facts();
    if let Some((part, horizon)) = facts.below
        && eye.is_none_or(|eye| horizon.distance(eye) < 0.0)
    {
        names.all(&[part]);
        names.all(facts.momentum_parts);
    }
    names.add(if choice.purpose == Purpose::Pixels { "camera/pixels_chosen" } else { "camera/pixels_all" });
    if choice.purpose.is_given() {
        names.all(&["camera/ray", "camera/given"]);
        names.add(if scene.rays.asymptotic { "camera/arrival/from_infinity" } else { "camera/arrival/as_given" });
        return;
    }
    names.all(&["camera/ray"]);
    match scene.image.pattern {
        _ if scene.image.samples == 1 => names.add("camera/sample/center"),
        SamplePattern::MultiJittered => names.add("camera/sample/multi_jittered"),
        SamplePattern::Progressive => names.all(&["camera/sample/scrambled", "camera/sample/sobol"]),
    }
    names.add(match (choice.adapts(scene), choice.keeps_footprints(scene)) {
        (true, _) => "camera/sample/corner_first",
        (false, true) => "camera/sample/corners_apart",
        (false, false) => "camera/sample/from_first",
    });
    names.add(if scene.rays.asymptotic { "camera/arrival/along_orbit" } else { "camera/arrival/straight" });
    // A scene that is only traced is checked as with any camera.
    let camera = scene.camera.as_ref();
    names.add(camera.map_or("camera/pinhole", |camera| camera.projection.part()));
    let frame = camera.and_then(|camera| scene.law.frame_part(camera.frame));
    names.add(frame.unwrap_or("camera/frame_coordinate"));
    match camera.and_then(|camera| Some((&*camera.projection, camera.stereo?))) {
        Some((projection, stereo)) => stereo_parts(projection, stereo, names),
        None => names.add("camera/view/one"),
    }
}

/// A picture of two views.
fn stereo_parts(projection: &dyn Projection, stereo: Stereo, names: &mut Names) {
    names.add(match stereo.layout {
        StereoLayout::SideBySide => "camera/view/side_by_side",
        StereoLayout::TopBottom => "camera/view/top_bottom",
    });
    names.add(if stereo.convergence.is_some() { projection.convergence_part() } else { "camera/eyes/parallel" });
}

pub(super) fn picture_parts(scene: &Scene, choice: &Choice, names: &mut Names) -> Result<(), ProgramError> {
    names.add(if scene.is_transparent() { "picture/coverage_kept" } else { "picture/coverage_none" });
    if scene.sky == Sky::Transparent {
        let carries = choice.follows_paths(scene) || choice.sees_glow(scene);
        names.add(if carries { "picture/open_path" } else { "picture/open_ray" });
    }
    match &scene.beyond {
        Some(beyond) => {
            names.add("picture/sky/both");
            for unit in two_skies(scene.sky.part(), beyond.part())? {
                names.make(unit);
            }
        }
        None => names.add(scene.sky.part()),
    }
    names.all(&[samples_part(scene, choice)]);
    if choice.adapts(scene) {
        names.add(match scene.output.tonemap {
            Tonemap::None => "picture/tonemap_none",
            Tonemap::Filmic => "picture/tonemap_filmic",
        });
    }
    if choice.knows_shift(scene) {
        shift_parts(scene, choice, names);
        names.all(scene.law.facts().momentum_parts);
    } else if choice.layers.contains(&Layer::Shift) {
        names.add("picture/shift_unknown");
    }
    if choice.shifts_hues(scene) {
        names.all(&["picture/beaming_hues", "surface/black_body"]);
    } else if choice.beams(scene) {
        names.add("picture/beaming");
    }
    if choice.keeps_orders(scene) {
        names.add("picture/orders_kept");
    }
    let layers: Vec<_> = choice.layers.iter().filter(|layer| layer.is_of_a_ray()).map(|layer| layer.name()).collect();
    if layers.is_empty() {
        names.add("picture/layers_none");
    } else {
        names.add("picture/layers_kept");
        names.each("picture/layer", layers.iter().copied());
        names.make(generated::layers(&layers));
    }
    Ok(())
}

/// By how much light has shifted.
fn shift_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    if !choice.follows_shift(scene) {
        names.add("picture/shift");
        return;
    }
    names.add("picture/shift_in_time");
    names.add(match scene.rays.precision {
        Precision::Double => "picture/stretch_buffer",
        Precision::Single | Precision::Half => "picture/stretch_texture",
    });
}

/// Which pixels take a sample, and what is kept of their corners.
pub(super) fn samples_part(scene: &Scene, choice: &Choice) -> &'static str {
    match (choice.adapts(scene), choice.keeps_footprints(scene)) {
        (true, _) => "picture/adaptive",
        (false, true) => "picture/samples_footprints",
        (false, false) => "picture/samples_all",
    }
}

pub(super) fn material_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    let used = || scene.used_materials();
    let ends = || used().filter(|material| !material.surface.continues());
    let mut kinds: Vec<&str> = ends().map(|material| scene.part_of(material)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let filtered = |part| if choice.keeps_footprints(scene) && part == "checker" { "checker_filtered" } else { part };
    let is_used = |part: &str, has_vertex_colors: bool| {
        used().any(|material| (material.color.part(), material.color.has_vertex_colors()) == (part, has_vertex_colors))
    };
    let patterns = Pattern::PARTS.into_iter().flat_map(|part| [(part, false), (part, true)]);
    let patterns: Vec<(&str, bool)> = patterns
        .filter(|(part, has_vertex_colors)| is_used(part, *has_vertex_colors))
        .map(|(part, has_vertex_colors)| (filtered(part), has_vertex_colors))
        .collect();
    let lights = [
        ("point", scene.lights.iter().any(|light| light.is_point() && !light.shadows.follows_the_law())),
        ("directional", scene.lights.iter().any(|light| !light.is_point() && !light.shadows.follows_the_law())),
        ("shot", scene.lights.iter().any(|light| light.shadows == Shadows::Shooting)),
        ("grid", scene.lights.iter().any(|light| light.shadows == Shadows::Grid)),
    ];
    let lights: Vec<&str> =
        lights.into_iter().filter(|(_, there)| *there && scene.is_lit()).map(|(name, _)| name).collect();
    names.add("surface/material");
    names.all(&kinds);
    names.each("surface/pattern", patterns.iter().map(|(part, _)| *part));
    if scene.uses_vertex_colors() {
        names.add("surface/vertex_colors");
    }
    names.each("surface/light", lights.iter().copied());
    names.add(if lights.is_empty() { "surface/light/none" } else { "surface/light/blinn_phong" });
    let falls = scene.lights.iter().any(|light| light.falls);
    names.add(if falls { "surface/light/falls_some" } else { "surface/light/falls_none" });
    if lights.contains(&"grid") {
        names.add("surface/light/field");
        grid_parts(scene, names);
    }
    let parts_of = |wanted: fn(&dyn Surface) -> bool| -> Vec<&str> {
        ends().filter(|material| wanted(&*material.surface)).map(|material| scene.part_of(material)).collect()
    };
    let tempered = parts_of(Surface::has_temperature);
    let beaming = choice.beams(scene);
    if !tempered.is_empty() {
        names.add("surface/black_body");
        names.all(if beaming { &[] } else { &["surface/unshifted"] });
    }
    names.make(generated::materials(&generated::Answers {
        kinds: &kinds,
        tempered: &tempered,
        orbiting: &parts_of(Surface::orbits),
        patterns: &patterns,
        lights: &lights,
        paths: choice.follows_paths(scene),
        shift: choice.knows_shift(scene) && !choice.follows_shift(scene),
        beaming,
    }));
}

/// How bright the lights are that have a grid.
fn grid_parts(scene: &Scene, names: &mut Names) {
    let lights = || scene.lights.iter().filter(|light| light.shadows == Shadows::Grid);
    let all = lights().all(Light::falls_in_grid);
    if !all {
        names.add("surface/light/even_share");
    }
    names.add(match (all, lights().any(Light::falls_in_grid)) {
        (true, _) => "surface/light/grid_falls_all",
        (false, true) => "surface/light/grid_falls_some",
        (false, false) => "surface/light/grid_falls_none",
    });
}
