//! The parts of pictures: where samples lie, the camera, what is seen, and what is made of it.

use super::names::Names;
use super::{Choice, Purpose, generated};
use crate::model::{CameraFrame, Pattern, Projection, Stereo, StereoLayout};
use crate::scene::{Light, SamplePattern, Scene, Sky, Tonemap};

pub(super) fn camera_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    names.add(if choice.purpose == Purpose::Pixels { "sample/chosen_pixels" } else { "sample/every_pixel" });
    if choice.purpose == Purpose::Trace {
        names.all(&["camera/ray", "camera/given", "view/one", "sample/index"]);
        names.add(if scene.rays.asymptotic { "arrival/from_infinity" } else { "arrival/as_given" });
        return;
    }
    names.all(&["camera/ray", "sample/image_plane"]);
    names.add(if scene.rays.asymptotic { "arrival/along_orbit" } else { "arrival/straight" });
    match scene.image.pattern {
        _ if scene.image.samples == 1 => names.add("sample/center"),
        SamplePattern::MultiJittered => names.add("sample/multi_jittered"),
        SamplePattern::Progressive if choice.adapts(scene) => names.all(&["sample/sobol", "sample/adaptive"]),
        SamplePattern::Progressive => names.all(&["sample/sobol", "sample/progressive"]),
    }
    let Some(camera) = &scene.camera else { return };
    names.add(camera.projection.part());
    names.add(match camera.frame {
        CameraFrame::Static => "frame/static",
        CameraFrame::Coordinate => "frame/coordinate",
    });
    match camera.stereo {
        Some(stereo) => stereo_parts(&*camera.projection, stereo, names),
        None => names.add("view/one"),
    }
}

/// A picture of two views.
fn stereo_parts(projection: &dyn Projection, stereo: Stereo, names: &mut Names) {
    names.add(match stereo.layout {
        StereoLayout::SideBySide => "view/side_by_side",
        StereoLayout::TopBottom => "view/top_bottom",
    });
    names.add(if stereo.convergence.is_some() { projection.convergence_part() } else { "eyes/parallel" });
}

pub(super) fn picture_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    names.add(if scene.is_transparent() { "coverage/kept" } else { "coverage/none" });
    names.add(match scene.sky {
        Sky::Color(_) => "sky/color",
        Sky::Equirectangular(..) => "sky/equirectangular",
        Sky::Faces(..) => "sky/faces",
    });
    if choice.adapts(scene) {
        names.all(&["sum/one_sample", "corner/kept", "moments", "displayed"]);
        names.add(match scene.output.tonemap {
            Tonemap::None => "tonemap/none",
            Tonemap::Filmic => "tonemap/filmic",
        });
    } else {
        names.all(&["sum/all_samples", "corner/none"]);
    }
    let layers: Vec<_> = choice.layers.iter().filter(|layer| layer.is_of_a_ray()).map(|layer| layer.name()).collect();
    if layers.is_empty() {
        names.add("layer/none");
    } else {
        names.add("layer/kept");
        names.each("layer", layers.iter().copied());
        names.make(generated::layers(&layers));
    }
}

pub(super) fn material_parts(scene: &Scene, names: &mut Names) {
    let used = || scene.objects.iter().filter_map(|object| scene.material_of(object));
    let ends = || used().filter(|material| !material.surface.continues());
    let mut kinds: Vec<&str> = ends().map(|material| material.surface.part()).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let is_lit = ends().any(|material| material.surface.is_lit());
    let patterns: Vec<&str> =
        Pattern::PARTS.into_iter().filter(|part| used().any(|material| material.color.part() == *part)).collect();
    let lights = [
        ("point", scene.lights.iter().any(|light| matches!(light, Light::Point { .. }))),
        ("directional", scene.lights.iter().any(|light| matches!(light, Light::Directional { .. }))),
    ];
    let lights: Vec<&str> = lights.into_iter().filter(|(_, there)| *there && is_lit).map(|(name, _)| name).collect();
    names.add("material/material");
    names.all(&kinds);
    names.each("pattern", patterns.iter().copied());
    names.each("light", lights.iter().copied());
    names.add(if lights.is_empty() { "light/none" } else { "light/blinn_phong" });
    names.make(generated::materials(&kinds, &patterns, &lights));
}
