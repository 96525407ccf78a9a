//! The plan: which parts a scene is made of. One file per contract; the cheapest that is right for the scene.

use super::link::{Parts, Unit};
use super::picture_parts::{camera_parts, material_parts, picture_parts};
use super::region_parts::region_parts;
use super::regions::{Kind, Regions, is_mirror, scatters};
use super::{Choice, Masks, ProgramError, Purpose, Structure, Work, generated, part};
use crate::scene::{
    Branches, Control, Law, MaterialKind, Medium, Object, Precision, Scene, SchwarzschildForm, Segment, Shape,
};

/// The parts of `scene`'s program. Parts of a contract that a pass does not call are left out when it is linked.
pub fn plan(scene: &Scene, choice: &Choice, work: &Work) -> Result<Parts, ProgramError> {
    let mut names = Names::default();
    names.all(&[
        "segment/ray",
        "state/arguments",
        "state/work",
        "law/bound",
        "real/math",
        "state/tally",
        "segment/termination",
        "segment/path_end",
        "picture/colors",
    ]);
    names.all(&["state/ray", "state/active", "state/finish"]);
    names.all(match scene.rays.precision {
        Precision::Half => &["real/f32", "state/texture", "state/texels_f16"],
        Precision::Single => &["real/f32", "state/texture", "state/texels_f32"],
        Precision::Double => &["real/f64", "state/buffer"],
    });
    let regions = Regions::of(scene);
    let mut made = vec![generated::counts(scene)];
    phase_parts(scene, &mut names);
    scatter_parts(scene, choice, &regions, &mut names, &mut made);
    names.each("pass", choice.passes(scene).iter().map(|pass| pass.entry()));
    schedule_parts(scene, choice, &regions, &mut names);
    camera_parts(scene, choice, &mut names);
    end_parts(scene, &mut names);
    surface_parts(scene, work, &regions, &mut names, &mut made);
    if choice.purpose == Purpose::Picture {
        picture_parts(scene, choice, &mut names, &mut made);
    }
    if !scene.pictures.is_empty() {
        names.add("surface/image_sample");
        made.push(generated::images(scene.pictures.len()));
    }
    if !scene.objects.is_empty() {
        material_parts(scene, &mut names, &mut made);
    }
    let mut shared = names.units()?;
    shared.extend(made);
    let regions = regions.kinds.iter().map(|kind| region_parts(scene, choice.purpose, &regions, kind));
    Ok(Parts { shared, regions: regions.collect::<Result<_, _>>()? })
}

/// The names of the parts chosen so far.
#[derive(Default)]
pub(super) struct Names(Vec<String>);

impl Names {
    pub(super) fn add(&mut self, name: &str) {
        self.all(&[name]);
    }

    pub(super) fn all(&mut self, names: &[&str]) {
        self.each_of(names.iter().map(|name| (*name).to_owned()));
    }

    pub(super) fn each<'a>(&mut self, folder: &str, files: impl IntoIterator<Item = &'a str>) {
        self.each_of(files.into_iter().map(|file| format!("{folder}/{file}")));
    }

    fn each_of(&mut self, names: impl IntoIterator<Item = String>) {
        for name in names {
            if !self.0.contains(&name) {
                self.0.push(name);
            }
        }
    }

    pub(super) fn units(&self) -> Result<Vec<Unit>, ProgramError> {
        self.0.iter().map(|name| part(name).map(Unit::from).ok_or_else(|| ProgramError::NoPart(name.clone()))).collect()
    }
}

fn schedule_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    names.add(match choice.masks {
        Masks::Off => "state/active/all",
        Masks::Grid => "state/active/grid",
        Masks::List => "state/active/list",
    });
    names.add(if choice.masks == Masks::Off { "segment/run_all" } else { "segment/run_active" });
    names.add(match (choice.lists_open(scene), choice.rounds(scene) > 1) {
        (false, _) => "state/round/once",
        (true, false) => "state/round/chosen",
        (true, true) => "state/round/open",
    });
    names.add(if choice.adapts(scene) { "picture/adaptive" } else { "picture/samples_all" });
    names.add(if choice.slots(scene) == 3 { "state/slots_three" } else { "state/slots_two" });
    names.add(if choice.keeps_counts() { "state/counts_kept" } else { "state/counts_none" });
    let rejects = matches!(scene.rays.control, Control::Embedded { .. } | Control::Doubling { .. });
    names.add(if rejects { "state/rejections_some" } else { "state/rejections_none" });
    names.add(if keeps_taken(scene, regions) { "state/taken_kept" } else { "state/taken_none" });
}

/// Arcs that are not straight need their step's size in the pass that intersects them.
fn keeps_taken(scene: &Scene, regions: &Regions) -> bool {
    let arcs = matches!(scene.rays.segment, Segment::Arc { .. }) && !regions.kinds.iter().all(Kind::is_line);
    arcs && !scene.objects.is_empty()
}

/// What a state is, and what the control remembers of it.
fn phase_parts(scene: &Scene, names: &mut Names) {
    let spacetime = matches!(scene.law, Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. });
    names.add(if spacetime { "law/phase_spacetime" } else { "law/phase_space" });
    // Embedded pairs remember the error of the step before.
    let pair = matches!(scene.rays.control, Control::Embedded { .. });
    names.add(if pair { "method/memory_pair" } else { "method/memory_step" });
}

/// Which medium a ray is in, and what becomes of it at surfaces that it goes on from.
fn scatter_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names, made: &mut Vec<Unit>) {
    if !scatters(scene) {
        names.all(&[
            "surface/region_none",
            "surface/scatter/none",
            "surface/weight/none",
            "surface/branch/transmitted",
            "segment/last_hit_none",
            "shape/facing_any",
        ]);
        return;
    }
    let clear = scene.objects.iter().any(|object| object.interior().is_some());
    let flat = scene.objects.iter().enumerate().any(|(i, o)| is_mirror(scene, o) && regions.bit(i).is_none());
    let sided_mesh = regions.regions.iter().any(|r| matches!(scene.objects[r.object].shape, Shape::Mesh(_)));
    names.all(&["surface/scatter/some"]);
    names.add(if regions.regions.is_empty() { "surface/region_none" } else { "surface/region_set" });
    names.add(if choice.purpose == Purpose::Trace { "surface/origin_given" } else { "surface/origin_camera" });
    names.add(if flat { "segment/last_hit_kept" } else { "segment/last_hit_none" });
    names.add(if sided_mesh { "shape/facing_sided" } else { "shape/facing_any" });
    names.add(if regions.touching.count() > 0 { "surface/touching_some" } else { "surface/touching_none" });
    let gray = scene.materials.iter().all(|material| material.kind != MaterialKind::Mirror || material.color.is_gray());
    let kept = if gray { "surface/weight/gray" } else { "surface/weight/colored" };
    let (weight, branch) = match (choice.purpose, scene.rays.branches) {
        (Purpose::Picture, Branches::Enumerated(_)) => (kept, "surface/branch/enumerated"),
        (Purpose::Picture, Branches::Random) => (kept, "surface/branch/random"),
        _ => ("surface/weight/none", "surface/branch/transmitted"),
    };
    names.all(&[weight, branch]);
    if clear {
        names.all(&["surface/scatter/transmissive"]);
    }
    let kinds = chosen(&[("transmissive", clear), ("mirror", scene.objects.iter().any(|o| is_mirror(scene, o)))]);
    names.each("surface/scatter", kinds.iter().copied().filter(|kind| *kind != "transmissive"));
    made.push(generated::scatter(&kinds));
    made.push(generated::regions(regions));
}

fn end_parts(scene: &Scene, names: &mut Names) {
    let captures = match &scene.law {
        Law::Schwarzschild { .. } => true,
        Law::Sources(sources) => sources.iter().any(|source| source.capture > 0.0),
        _ => scene.media().any(Medium::captures),
    };
    names.add(if captures { "law/capture_spheres" } else { "law/capture_none" });
    names.add(if scene.rays.length.is_some() { "law/limit_length" } else { "law/limit_none" });
    names.add(if scene.rays.asymptotic { "law/asymptotic_orbit" } else { "law/asymptotic_none" });
    let hits = !scene.objects.is_empty();
    match scene.rays.segment {
        Segment::Arc { .. } => {
            names.all(&["segment/follow_step", if hits { "segment/end_on_arc" } else { "segment/end_open" }]);
        }
        Segment::Chord { .. } => {
            names.all(&["segment/follow_chord", if hits { "segment/end_on_chord" } else { "segment/end_open" }]);
        }
    }
}

/// The kinds of shape of some objects: their parts' and functions' names.
pub(super) fn shape_kinds<'a>(objects: impl Iterator<Item = &'a Object>) -> Vec<&'static str> {
    let mut kinds: Vec<&str> = objects.map(|object| shape_kind(&object.shape, &object.transform)).collect();
    kinds.sort_unstable();
    kinds.dedup();
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

fn surface_parts(scene: &Scene, work: &Work, regions: &Regions, names: &mut Names, made: &mut Vec<Unit>) {
    let kinds = shape_kinds(scene.objects.iter());
    if kinds.is_empty() {
        names.all(&["segment/no_surfaces"]);
        return;
    }
    names.all(&["segment/pieces", "segment/hits", "shape/placed"]);
    let structure = Structure::of(scene);
    names.add(if work.resumed { "segment/walk_resumed" } else { "segment/walk_whole" });
    let leaps = regions.kinds.iter().any(|kind| kind.leaps);
    names.add(if leaps { "segment/hit_leaping" } else { "segment/hit_direct" });
    names.each("shape", kinds.iter().copied());
    let with_side = |side: bool| {
        let objects = scene.objects.iter().enumerate().filter(move |(i, _)| regions.bit(*i).is_some() == side);
        shape_kinds(objects.map(|(_, object)| object))
    };
    let (opaque, mut sided) = (with_side(false), with_side(true));
    // One search meets all triangles, whatever their objects are made of.
    sided.retain(|kind| *kind != "triangle");
    let listed: Vec<&str> = opaque.into_iter().filter(|kind| !structure.holds(kind)).collect();
    names.add(if listed.is_empty() && sided.is_empty() { "segment/lists_none" } else { "segment/lists_some" });
    if structure.kinds.is_empty() {
        names.add("segment/structure/none");
    } else {
        names.add("segment/pieces");
        names.add(if structure.in_order() { "segment/order_same" } else { "segment/order_listed" });
        names.each("segment/structure", [structure.search.name()]);
    }
    made.push(generated::shapes(scene, &kinds, &listed, &sided, &structure));
    names.add("surface/seen");
}

pub(super) fn chosen<'a>(options: &[(&'a str, bool)]) -> Vec<&'a str> {
    options.iter().filter(|(_, used)| *used).map(|(name, _)| *name).collect()
}
