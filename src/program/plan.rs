//! The plan: which parts a scene is made of. One file per contract; the cheapest that is right for the scene.

use super::link::{Parts, Unit};
use super::{Choice, ProgramError, Purpose, Schedule, Work, generated, part};
use crate::scene::{
    CameraKind, Control, DoublingRule, Falloff, FlowField, FlowOrder, Frame, Law, Light, MaterialKind, Medium, Method,
    Pattern, Precision, Scene, SchwarzschildForm, Segment, Shape, Sky,
};

/// The parts of `scene`'s program. Parts of a contract that a pass does not call are left out when it is linked.
pub fn plan(scene: &Scene, choice: &Choice, work: &Work) -> Result<Parts, ProgramError> {
    let mut names = Names::default();
    names.all(&["ray", "frame", "work", "bound", "schedule", "turn", "math", "tally/totals", "fate", "path_end"]);
    names.all(&["state/ray", "living/place", "stage/ended", "stage/between"]);
    names.all(match scene.rays.precision {
        Precision::Half => &["real/f32", "state/texture", "state/texels_f16"],
        Precision::Single => &["real/f32", "state/texture", "state/texels_f32"],
        Precision::Double => &["real/f64", "state/buffer"],
    });
    let mut made = vec![generated::counts(scene)];
    names.each("pass", choice.passes(scene).iter().map(|pass| pass.entry()));
    schedule_parts(scene, choice, &mut names);
    camera_parts(scene, choice, &mut names);
    end_parts(scene, &mut names);
    surface_parts(scene, choice, work, &mut names, &mut made);
    if choice.purpose == Purpose::Picture {
        picture_parts(scene, choice, &mut names, &mut made);
    }
    let mut shared = names.units()?;
    shared.extend(made);
    let mut region = Names::default();
    region.add("region/none");
    region_parts(scene, choice.purpose, &mut region, &mut shared);
    Ok(Parts { shared, regions: vec![region.units()?] })
}

/// The names of the parts chosen so far.
#[derive(Default)]
struct Names(Vec<String>);

impl Names {
    fn add(&mut self, name: &str) {
        self.0.push(name.to_owned());
    }

    fn all(&mut self, names: &[&str]) {
        self.each_of(names.iter().map(|name| (*name).to_owned()));
    }

    fn each<'a>(&mut self, folder: &str, files: impl IntoIterator<Item = &'a str>) {
        self.each_of(files.into_iter().map(|file| format!("{folder}/{file}")));
    }

    fn each_of(&mut self, names: impl IntoIterator<Item = String>) {
        self.0.extend(names);
    }

    fn units(&self) -> Result<Vec<Unit>, ProgramError> {
        self.0.iter().map(|name| part(name).map(Unit::from).ok_or_else(|| ProgramError::NoPart(name.clone()))).collect()
    }
}

fn schedule_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    names.add(match (choice.masks, choice.schedule) {
        (false, _) => "living/all",
        (true, Schedule::Fused) => "living/list",
        (true, _) => "living/grid",
    });
    names.add(if choice.slots(scene) == 3 { "slots/three" } else { "slots/two" });
    names.add(if choice.keeps_counts() { "counts/kept" } else { "counts/none" });
    let rejects = matches!(scene.rays.control, Control::Embedded { .. } | Control::Doubling { .. });
    names.add(if rejects { "tally/rejections" } else { "tally/no_rejections" });
    names.add(if keeps_taken(scene) { "stage/taken_kept" } else { "stage/taken_none" });
}

/// Arcs that are not straight need their step's size in the pass that intersects them.
pub(super) fn keeps_taken(scene: &Scene) -> bool {
    matches!(scene.rays.segment, Segment::Arc { .. }) && scene.rays.method != Method::Exact && !scene.objects.is_empty()
}

fn camera_parts(scene: &Scene, choice: &Choice, names: &mut Names) {
    names.add(if choice.purpose == Purpose::Pixels { "sample/chosen_pixels" } else { "sample/every_pixel" });
    if choice.purpose == Purpose::Trace {
        names.all(&["camera/ray", "camera/given", "sample/index"]);
        names.add(if scene.rays.asymptotic { "arrival/from_infinity" } else { "arrival/as_given" });
        return;
    }
    let camera = scene.camera.as_ref();
    names.all(&["camera/ray", "sample/image_plane"]);
    names.add(if scene.rays.asymptotic { "arrival/along_orbit" } else { "arrival/straight" });
    names.add(match camera.map(|c| c.kind) {
        Some(CameraKind::Plane { .. }) => "camera/plane",
        _ => "camera/pinhole",
    });
    names.add(match camera.map(|c| c.frame) {
        Some(Frame::Static) => "frame/static",
        _ => "frame/coordinate",
    });
    names.add(if scene.image.samples > 1 { "sample/multi_jittered" } else { "sample/center" });
}

fn end_parts(scene: &Scene, names: &mut Names) {
    let captures = match &scene.law {
        Law::Schwarzschild { .. } => true,
        Law::Sources(sources) => sources.iter().any(|source| source.capture > 0.0),
        _ => false,
    };
    names.add(if captures { "capture/spheres" } else { "capture/none" });
    names.add(if scene.rays.length.is_some() { "limit/length" } else { "limit/none" });
    let hits = !scene.objects.is_empty();
    match scene.rays.segment {
        Segment::Arc { .. } => {
            names.all(&["follow/step", if hits { "stage/end_on_arc" } else { "stage/end_open" }]);
            names.add(if scene.rays.method == Method::Exact { "curve/line" } else { "curve/arc" });
        }
        Segment::Chord { .. } => {
            names.all(&["follow/steps", "curve/line", if hits { "stage/end_on_chord" } else { "stage/end_open" }]);
        }
    }
}

/// The kinds of shape of the scene: their parts' and functions' names.
#[must_use]
pub fn shape_kinds(scene: &Scene) -> Vec<&'static str> {
    let mut kinds: Vec<&str> =
        scene.objects.iter().map(|object| shape_kind(&object.shape, &object.transform)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    // Meshes last: what is nearer already shortens their walk.
    kinds.sort_by_key(|kind| *kind == "triangle");
    kinds
}

/// The kind of shape that an object is to the shaders.
#[must_use]
pub fn shape_kind(shape: &Shape, transform: &crate::scene::Transform) -> &'static str {
    match shape {
        Shape::Sphere if transform.uniform_scale().is_some() => "sphere",
        Shape::Sphere => "ellipsoid",
        Shape::Plane => "plane",
        Shape::Box => "box",
        Shape::Cylinder => "cylinder",
        Shape::Disk { .. } => "disk",
        Shape::Mesh(_) => "triangle",
    }
}

fn surface_parts(scene: &Scene, choice: &Choice, work: &Work, names: &mut Names, made: &mut Vec<Unit>) {
    let recorded = choice.purpose != Purpose::Picture;
    let kinds = shape_kinds(scene);
    if kinds.is_empty() {
        names.all(&["walk/none", "stage/seen_nothing"]);
        names.add(if recorded { "stage/recorded_nothing" } else { "stage/seen" });
        return;
    }
    names.all(&["walk/piece", "hits", "shape/placed"]);
    names.add(if work.resumed { "walk/resumed" } else { "walk/whole" });
    names.each("shape", kinds.iter().copied());
    made.push(generated::shapes(&kinds));
    if recorded {
        names.add("stage/recorded_surface");
    } else {
        names.all(&["stage/seen", "stage/seen_surface"]);
    }
}

fn picture_parts(scene: &Scene, choice: &Choice, names: &mut Names, made: &mut Vec<Unit>) {
    names.add(match scene.sky {
        Sky::Color(_) => "sky/color",
        Sky::Equirectangular(..) => "sky/equirectangular",
        Sky::Faces(..) => "sky/faces",
    });
    if !scene.pictures.is_empty() {
        names.add("image_sample");
        made.push(generated::images(scene.pictures.len()));
    }
    if choice.layers.is_empty() {
        names.add("layer/none");
    } else {
        names.add("layer/kept");
        let layers: Vec<_> = choice.layers.iter().map(|layer| layer.name()).collect();
        names.each("layer", layers.iter().copied());
        made.push(generated::layers(&layers));
    }
    if !scene.objects.is_empty() {
        material_parts(scene, names, made);
    }
}

fn material_parts(scene: &Scene, names: &mut Names, made: &mut Vec<Unit>) {
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

fn chosen<'a>(options: &[(&'a str, bool)]) -> Vec<&'a str> {
    options.iter().filter(|(_, used)| *used).map(|(name, _)| *name).collect()
}

/// How light travels: the parts of which every kind of region has its own.
fn region_parts(scene: &Scene, purpose: Purpose, names: &mut Names, shared: &mut Vec<Unit>) {
    let spacetime = matches!(scene.law, Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. });
    names.add(if spacetime { "phase/spacetime" } else { "phase/space" });
    names.add(if keeps_error(scene) { "memory/pair" } else { "memory/step" });
    names.add(if scene.rays.asymptotic { "asymptotic/orbit" } else { "asymptotic/none" });
    names.add(if scene.rays.method == Method::Planar { "pace/orbit" } else { "pace/tau" });
    if scene.rays.method == Method::Planar || scene.rays.asymptotic {
        orbit_parts(&scene.law, names);
    }
    match scene.rays.method {
        Method::Exact => {
            names.add("motion/straight");
            return;
        }
        Method::Planar => {
            law_parts(&scene.law, names, shared);
            planar_parts(scene, purpose, names);
            return;
        }
        _ => {}
    }
    law_parts(&scene.law, names, shared);
    step_parts(scene.rays.method, names);
    control_parts(scene.rays.control, names);
}

/// The plane of a ray about its law's only centre.
fn orbit_parts(law: &Law, names: &mut Names) {
    names.add("orbit/orbit");
    match law {
        Law::Schwarzschild { .. } => names.add("orbit/schwarzschild"),
        Law::Sources(sources) => names.add(match sources.first().map(|source| source.falloff) {
            Some(Falloff::Cubic { .. }) => "orbit/cubic",
            Some(Falloff::Yukawa { .. }) => "orbit/yukawa",
            _ => "orbit/inverse_square",
        }),
        _ => {}
    }
}

/// τ is integrated only where something asks for it: arcs, and the numbers of a trace.
fn planar_parts(scene: &Scene, purpose: Purpose, names: &mut Names) {
    let open = scene.objects.is_empty();
    names.add(if open { "motion/planar_open" } else { "motion/planar" });
    names.add(if open && purpose == Purpose::Picture { "clock/none" } else { "clock/kept" });
}

/// Embedded pairs remember the error of the step before.
fn keeps_error(scene: &Scene) -> bool {
    matches!(scene.rays.control, Control::Embedded { .. })
}

fn step_parts(method: Method, names: &mut Names) {
    match method {
        Method::Exact | Method::Planar => {}
        Method::Euler => names.add("step/euler"),
        Method::Leapfrog => names.add("step/leapfrog"),
        Method::Rkn4 => names.add("step/rkn4"),
        Method::Rk4 => names.add("step/rk4"),
        Method::Snell { .. } => names.add("step/snell"),
        Method::BogackiShampine => names.all(&["step/pair", "step/bogacki_shampine"]),
        Method::DormandPrince => names.all(&["step/pair", "step/dormand_prince"]),
    }
}

fn control_parts(control: Control, names: &mut Names) {
    match control {
        Control::Exact => {}
        Control::Fixed { .. } => names.all(&["control/planned", "control/fixed"]),
        Control::Scaled { .. } => names.all(&["control/planned", "control/scaled"]),
        Control::Curvature { .. } => names.all(&["control/planned", "control/curvature"]),
        Control::Embedded { .. } => names.add("control/embedded"),
        Control::Doubling { rule: DoublingRule::Paper, .. } => {
            names.all(&["control/doubled", "control/doubling_paper"]);
        }
        Control::Doubling { rule: DoublingRule::Rejecting, .. } => {
            names.all(&["control/doubled", "control/doubling_rejecting"]);
        }
    }
}

/// The part that knows a medium's index.
fn index_part(medium: &Medium) -> &'static str {
    match medium {
        Medium::Constant { .. } => "index/constant",
        Medium::Luneburg { .. } => "index/luneburg",
        Medium::Gaussian { .. } => "index/gaussian",
        Medium::InverseR { .. } => "index/inverse_r",
        Medium::Fisheye { .. } => "index/fisheye",
        Medium::Eaton { .. } => "index/eaton",
        Medium::Rod { .. } => "index/rod",
        Medium::Linear { .. } => "index/linear",
        Medium::Exponential { .. } => "index/exponential",
        Medium::Sech { .. } => "index/sech",
        Medium::Explosion(_) => "index/explosion",
    }
}

fn law_parts(law: &Law, names: &mut Names, shared: &mut Vec<Unit>) {
    let second_order = !matches!(
        law,
        Law::Flow { order: FlowOrder::Velocity, .. } | Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. }
    );
    if second_order {
        names.add("law/accelerated");
    }
    match law {
        Law::Straight => names.add("law/straight"),
        Law::Schwarzschild { form: SchwarzschildForm::Path, .. } => names.add("law/schwarzschild_path"),
        Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. } => names.add("law/schwarzschild_geodesic"),
        Law::Sources(sources) => {
            let falloffs = chosen(&[
                ("inverse_square", sources.iter().any(|s| s.falloff == Falloff::InverseSquare)),
                ("cubic", sources.iter().any(|s| matches!(s.falloff, Falloff::Cubic { .. }))),
                ("yukawa", sources.iter().any(|s| matches!(s.falloff, Falloff::Yukawa { .. }))),
            ]);
            names.all(&["law/sources", "falloff/far_away"]);
            names.each("falloff", falloffs.iter().copied());
            shared.push(generated::sources(&falloffs));
        }
        Law::Flow { field, order } => {
            names.add(match field {
                FlowField::Lorenz { .. } => "flow/lorenz",
                FlowField::Rossler { .. } => "flow/rossler",
            });
            names.add(match order {
                FlowOrder::Velocity => "law/flow",
                FlowOrder::Acceleration => "law/flow_acceleration",
            });
        }
        Law::Medium(medium) => {
            names.all(&["law/medium", index_part(medium)]);
            shared.push(generated::media(1));
        }
    }
}
