//! The parts of pictures: where samples lie, the camera, what is seen, and what is made of it.

use super::link::Unit;
use super::plan::{Names, chosen};
use super::{Choice, Purpose, generated};
use crate::scene::{
    CameraKind, Frame, Light, MaterialKind, Pattern, SamplePattern, Scene, Sky, Stereo, StereoLayout, Tonemap,
};

pub(super) fn camera_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    names.add(if choice.purpose == Purpose::Pixels { "camera/pixels_chosen" } else { "camera/pixels_all" });
    if choice.purpose == Purpose::Trace {
        names.all(&["camera/ray", "camera/given"]);
        names.add(if scene.rays.asymptotic { "camera/arrival/from_infinity" } else { "camera/arrival/as_given" });
        return;
    }
    names.all(&["camera/ray"]);
    names.add(if scene.rays.asymptotic { "camera/arrival/along_orbit" } else { "camera/arrival/straight" });
    match scene.image.pattern {
        _ if scene.image.samples == 1 => names.add("camera/sample/center"),
        SamplePattern::MultiJittered => names.add("camera/sample/multi_jittered"),
        SamplePattern::Progressive if choice.adapts(scene) => {
            names.all(&["camera/sample/sobol", "camera/sample/adaptive"]);
        }
        SamplePattern::Progressive => names.all(&["camera/sample/sobol", "camera/sample/progressive"]),
    }
    let camera = scene.camera.as_ref();
    names.add(match camera.map(|c| c.kind) {
        Some(CameraKind::Plane { .. }) => "camera/plane",
        Some(CameraKind::Fisheye { .. }) => "camera/fisheye",
        Some(CameraKind::Panorama { .. }) => "camera/panorama",
        Some(CameraKind::Pinhole { .. }) | None => "camera/pinhole",
    });
    names.add(match camera.map(|c| c.frame) {
        Some(Frame::Static) => "camera/frame_static",
        _ => "camera/frame_coordinate",
    });
    match camera.and_then(|camera| Some((camera.kind, camera.stereo?))) {
        Some((kind, stereo)) => stereo_parts(kind, stereo, names),
        None => names.add("camera/view/one"),
    }
}

/// A picture of two views.
fn stereo_parts(kind: CameraKind, stereo: Stereo, names: &mut Names) {
    names.add(match stereo.layout {
        StereoLayout::SideBySide => "camera/view/side_by_side",
        StereoLayout::TopBottom => "camera/view/top_bottom",
    });
    names.add(match (stereo.convergence, kind) {
        (None, _) => "camera/eyes/parallel",
        (Some(_), CameraKind::Pinhole { .. } | CameraKind::Plane { .. }) => "camera/eyes/crossing_plane",
        (Some(_), CameraKind::Fisheye { .. } | CameraKind::Panorama { .. }) => "camera/eyes/crossing_sphere",
    });
}

pub(super) fn picture_parts(scene: &Scene, choice: &Choice, names: &mut Names, made: &mut Vec<Unit>) {
    names.add(if scene.is_transparent() { "picture/coverage_kept" } else { "picture/coverage_none" });
    names.add(match scene.sky {
        Sky::Color(_) => "picture/sky/color",
        Sky::Equirectangular(..) => "picture/sky/equirectangular",
        Sky::Faces(..) => "picture/sky/faces",
    });
    if choice.adapts(scene) {
        names.all(&["picture/adaptive"]);
        names.add(match scene.output.tonemap {
            Tonemap::None => "picture/tonemap_none",
            Tonemap::Filmic => "picture/tonemap_filmic",
        });
    } else {
        names.all(&["picture/samples_all"]);
    }
    let layers: Vec<_> = choice.layers.iter().filter(|layer| layer.is_of_a_ray()).map(|layer| layer.name()).collect();
    if layers.is_empty() {
        names.add("picture/layers_none");
    } else {
        names.add("picture/layers_kept");
        names.each("picture/layer", layers.iter().copied());
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
    names.add("surface/material");
    names.each("surface/material", kinds.iter().copied());
    names.each("surface/pattern", patterns.iter().copied());
    names.each("surface/light", lights.iter().copied());
    names.add(if lights.is_empty() { "surface/light/none" } else { "surface/light/blinn_phong" });
    made.push(generated::materials(&kinds, &patterns, &lights));
}
