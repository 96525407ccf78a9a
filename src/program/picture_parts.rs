//! The parts of pictures: where samples lie, the camera, what is seen, and what is made of it.

use super::plan::{Names, chosen};
use super::unit::Unit;
use super::{Choice, Purpose, generated};
use crate::scene::{
    CameraKind, Frame, Light, MaterialKind, Pattern, SamplePattern, Scene, Sky, Stereo, StereoLayout, Tonemap,
};

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
    let camera = scene.camera.as_ref();
    names.add(match camera.map(|c| c.kind) {
        Some(CameraKind::Plane { .. }) => "camera/plane",
        Some(CameraKind::Fisheye { .. }) => "camera/fisheye",
        Some(CameraKind::Panorama { .. }) => "camera/panorama",
        Some(CameraKind::Pinhole { .. }) | None => "camera/pinhole",
    });
    names.add(match camera.map(|c| c.frame) {
        Some(Frame::Static) => "frame/static",
        _ => "frame/coordinate",
    });
    match camera.and_then(|camera| Some((camera.kind, camera.stereo?))) {
        Some((kind, stereo)) => stereo_parts(kind, stereo, names),
        None => names.add("view/one"),
    }
}

/// A picture of two views.
fn stereo_parts(kind: CameraKind, stereo: Stereo, names: &mut Names) {
    names.add(match stereo.layout {
        StereoLayout::SideBySide => "view/side_by_side",
        StereoLayout::TopBottom => "view/top_bottom",
    });
    names.add(match (stereo.convergence, kind) {
        (None, _) => "eyes/parallel",
        (Some(_), CameraKind::Pinhole { .. } | CameraKind::Plane { .. }) => "eyes/crossing_plane",
        (Some(_), CameraKind::Fisheye { .. } | CameraKind::Panorama { .. }) => "eyes/crossing_sphere",
    });
}

pub(super) fn picture_parts(scene: &Scene, choice: &Choice, names: &mut Names, made: &mut Vec<Unit>) {
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
        made.push(generated::layers(&layers));
    }
}

pub(super) fn material_parts(scene: &Scene, names: &mut Names, made: &mut Vec<Unit>) {
    let used = || scene.objects.iter().filter_map(|object| Some(&scene.materials[object.material()?]));
    let phong = used().any(|m| matches!(m.kind, MaterialKind::Phong { .. }));
    let kinds = chosen(&[("emissive", used().any(|m| m.kind == MaterialKind::Emissive)), ("phong", phong)]);
    let patterns = chosen(&[
        ("constant", used().any(|m| matches!(m.color, Pattern::Constant(_)))),
        ("checker", used().any(|m| matches!(m.color, Pattern::Checker { .. }))),
        ("image", used().any(|m| matches!(m.color, Pattern::Picture { .. }))),
    ]);
    let lights = chosen(&[
        ("point", phong && scene.lights.iter().any(|l| matches!(l, Light::Point { .. }))),
        ("directional", phong && scene.lights.iter().any(|l| matches!(l, Light::Directional { .. }))),
    ]);
    names.add("material/material");
    names.each("material", kinds.iter().copied());
    names.each("pattern", patterns.iter().copied());
    names.each("light", lights.iter().copied());
    names.add(if lights.is_empty() { "light/none" } else { "light/blinn_phong" });
    made.push(generated::materials(&kinds, &patterns, &lights));
}
