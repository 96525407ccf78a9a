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
        "ray",
        "frame",
        "work",
        "bound",
        "schedule",
        "turn",
        "math",
        "tally/totals",
        "fate",
        "path_end",
        "colors",
    ]);
    names.all(&["state/ray", "living/place", "stage/advanced"]);
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
    surface_parts(scene, choice, work, &regions, &mut names, &mut made);
    if choice.purpose == Purpose::Picture {
        picture_parts(scene, choice, &mut names, &mut made);
    }
    if !scene.pictures.is_empty() {
        names.add("image_sample");
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
        self.0.push(name.to_owned());
    }

    pub(super) fn all(&mut self, names: &[&str]) {
        self.each_of(names.iter().map(|name| (*name).to_owned()));
    }

    pub(super) fn each<'a>(&mut self, folder: &str, files: impl IntoIterator<Item = &'a str>) {
        self.each_of(files.into_iter().map(|file| format!("{folder}/{file}")));
    }

    fn each_of(&mut self, names: impl IntoIterator<Item = String>) {
        self.0.extend(names);
    }

    pub(super) fn units(&self) -> Result<Vec<Unit>, ProgramError> {
        self.0.iter().map(|name| part(name).map(Unit::from).ok_or_else(|| ProgramError::NoPart(name.clone()))).collect()
    }
}

fn schedule_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names) {
    names.add(match choice.masks {
        Masks::Off => "living/all",
        Masks::Grid => "living/grid",
        Masks::List => "living/list",
    });
    names.add(if choice.masks == Masks::Off { "follow/all" } else { "follow/living" });
    names.add(match (choice.lists_open(scene), choice.rounds(scene) > 1) {
        (false, _) => "round/once",
        (true, false) => "round/chosen",
        (true, true) => "round/open",
    });
    names.add(if choice.adapts(scene) { "wanted/open" } else { "wanted/all" });
    names.add(if choice.slots(scene) == 3 { "slots/three" } else { "slots/two" });
    names.add(if choice.keeps_counts() { "counts/kept" } else { "counts/none" });
    let rejects = matches!(scene.rays.control, Control::Embedded { .. } | Control::Doubling { .. });
    names.add(if rejects { "tally/rejections" } else { "tally/no_rejections" });
    names.add(if keeps_taken(scene, regions) { "stage/taken_kept" } else { "stage/taken_none" });
}

/// Arcs that are not straight need their step's size in the pass that intersects them.
fn keeps_taken(scene: &Scene, regions: &Regions) -> bool {
    let arcs = matches!(scene.rays.segment, Segment::Arc { .. }) && !regions.kinds.iter().all(Kind::is_line);
    arcs && !scene.objects.is_empty()
}

/// What a state is, and what the control remembers of it.
fn phase_parts(scene: &Scene, names: &mut Names) {
    let spacetime = matches!(scene.law, Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. });
    names.add(if spacetime { "phase/spacetime" } else { "phase/space" });
    // Embedded pairs remember the error of the step before.
    let pair = matches!(scene.rays.control, Control::Embedded { .. });
    names.add(if pair { "memory/pair" } else { "memory/step" });
}

/// Which medium a ray is in, and what becomes of it at surfaces that it goes on from.
fn scatter_parts(scene: &Scene, choice: &Choice, regions: &Regions, names: &mut Names, made: &mut Vec<Unit>) {
    names.add("stride/turn");
    if !scatters(scene) {
        names.all(&["region/none", "scatter/none", "weight/none", "branch/transmitted", "left/none", "facing/any"]);
        return;
    }
    let clear = scene.objects.iter().any(|object| object.interior().is_some());
    let flat = scene.objects.iter().enumerate().any(|(i, o)| is_mirror(scene, o) && regions.bit(i).is_none());
    let sided_mesh = regions.regions.iter().any(|r| matches!(scene.objects[r.object].shape, Shape::Mesh(_)));
    names.all(&["scatter/some", "scatter/scattered", "branch/branch"]);
    names.add(if regions.regions.is_empty() { "region/none" } else { "region/set" });
    names.add(if choice.purpose == Purpose::Trace { "origin/given" } else { "origin/camera" });
    names.add(if flat { "left/kept" } else { "left/none" });
    names.add(if sided_mesh { "facing/sided" } else { "facing/any" });
    names.add(if regions.touching.count() > 0 { "touching/some" } else { "touching/none" });
    let gray = scene.materials.iter().all(|material| material.kind != MaterialKind::Mirror || material.color.is_gray());
    let kept = if gray { "weight/gray" } else { "weight/colored" };
    let (weight, branch) = match (choice.purpose, scene.rays.branches) {
        (Purpose::Picture, Branches::Enumerated(_)) => (kept, "branch/enumerated"),
        (Purpose::Picture, Branches::Random) => (kept, "branch/random"),
        _ => ("weight/none", "branch/transmitted"),
    };
    names.all(&[weight, branch]);
    if clear {
        names.all(&["scatter/clear", "scatter/refraction"]);
    }
    let kinds = chosen(&[("clear", clear), ("mirror", scene.objects.iter().any(|o| is_mirror(scene, o)))]);
    names.each("scatter", kinds.iter().copied().filter(|kind| *kind != "clear"));
    made.push(generated::scatter(&kinds));
    made.push(generated::regions(regions));
}

fn end_parts(scene: &Scene, names: &mut Names) {
    let captures = match &scene.law {
        Law::Schwarzschild { .. } => true,
        Law::Sources(sources) => sources.iter().any(|source| source.capture > 0.0),
        _ => scene.media().any(Medium::captures),
    };
    names.add(if captures { "capture/spheres" } else { "capture/none" });
    names.add(if scene.rays.length.is_some() { "limit/length" } else { "limit/none" });
    names.add(if scene.rays.asymptotic { "asymptotic/orbit" } else { "asymptotic/none" });
    let hits = !scene.objects.is_empty();
    match scene.rays.segment {
        Segment::Arc { .. } => {
            names.all(&["follow/step", if hits { "stage/end_on_arc" } else { "stage/end_open" }]);
        }
        Segment::Chord { .. } => {
            names.all(&["follow/steps", if hits { "stage/end_on_chord" } else { "stage/end_open" }]);
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

fn surface_parts(
    scene: &Scene,
    choice: &Choice,
    work: &Work,
    regions: &Regions,
    names: &mut Names,
    made: &mut Vec<Unit>,
) {
    let recorded = choice.purpose != Purpose::Picture;
    let kinds = shape_kinds(scene.objects.iter());
    if kinds.is_empty() {
        names.all(&["walk/none", "stage/seen_nothing"]);
        names.add(if recorded { "stage/recorded_nothing" } else { "stage/seen" });
        return;
    }
    names.all(&["walk/piece", "hits", "shape/placed"]);
    let structure = Structure::of(scene);
    names.add(if work.resumed { "walk/resumed" } else { "walk/whole" });
    let leaps = regions.kinds.iter().any(|kind| kind.leaps);
    names.add(if leaps { "walk/leaping" } else { "walk/direct" });
    names.each("shape", kinds.iter().copied());
    let with_side = |side: bool| {
        let objects = scene.objects.iter().enumerate().filter(move |(i, _)| regions.bit(*i).is_some() == side);
        shape_kinds(objects.map(|(_, object)| object))
    };
    let (opaque, mut sided) = (with_side(false), with_side(true));
    // One search meets all triangles, whatever their objects are made of.
    sided.retain(|kind| *kind != "triangle");
    let listed: Vec<&str> = opaque.into_iter().filter(|kind| !structure.holds(kind)).collect();
    names.add(if listed.is_empty() && sided.is_empty() { "listed/none" } else { "listed/some" });
    if structure.kinds.is_empty() {
        names.add("structure/none");
    } else {
        names.add("walk/items");
        names.add(if structure.in_order() { "order/same" } else { "order/listed" });
        names.each("structure", [structure.search.name()]);
    }
    if !sided.is_empty() {
        names.add("crossing/crossing");
        names.each("crossing", sided.iter().copied());
    } else if regions.regions.iter().any(|region| matches!(scene.objects[region.object].shape, Shape::Mesh(_))) {
        names.add("crossing/crossing");
    }
    made.push(generated::shapes(scene, &kinds, &listed, &sided, &structure));
    if recorded {
        names.add("stage/recorded_surface");
    } else {
        names.all(&["stage/seen", "stage/seen_surface"]);
    }
}

pub(super) fn chosen<'a>(options: &[(&'a str, bool)]) -> Vec<&'a str> {
    options.iter().filter(|(_, used)| *used).map(|(name, _)| *name).collect()
}
