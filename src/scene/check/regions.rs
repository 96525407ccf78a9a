//! Interiors that overlap: which of them is there has to be said; and how many objects have an inside.
//!
//! One object inside of another needs no word: the inner one is there. Where two of the same priority overlap in part, or lie
//! in one place, nothing says which; that is found by points of each one's surface, so that an overlap smaller than their spacing may pass.

use crate::document::reader::Reader;
use crate::document::{Fault, Place};
use crate::model::{Material, Object, Substance};
use glam::DVec3;

/// Rays carry the set of the objects that they are in as so many bits; closed mirrors are among them.
const MOST: usize = 32;
/// Points on a surface.
const POINTS: usize = 400;
/// What is nearer to a surface than this part of its distance from the origin lies on it.
const TOUCHES: f64 = 1e-6;

/// Replaces objects on one side of which rays are by their solids. Those that one object has more than one of come last, so that
/// the numbers of all other objects stay those of the file.
pub fn solids(objects: Vec<(Place, Object)>, materials: &[Material]) -> Vec<(Place, Object)> {
    let (mut first, mut more) = (Vec::with_capacity(objects.len()), Vec::new());
    for (place, object) in objects {
        if !is_sided(&object, materials) {
            first.push((place, object));
            continue;
        }
        let mut solids = object.solids().into_iter().map(|solid| (place, solid));
        first.extend(solids.next());
        more.extend(solids);
    }
    first.extend(more);
    first
}

/// Are rays on one side of its surface, or the other?
fn is_sided(object: &Object, materials: &[Material]) -> bool {
    let continues = |i: usize| materials.get(i).is_some_and(|material| material.surface.facts().continues);
    match object.substance {
        Substance::Clear(_) => true,
        Substance::Opaque(material) => continues(material) && object.shape.refuses_interior().is_none(),
    }
}

/// Records what is wrong with the interiors of objects, each given with its place in the file.
pub fn check(reader: &Reader, objects: &[(Place, Object)], materials: &[Material]) {
    for (place, object) in objects {
        let is_translucent = |i: usize| materials.get(i).is_some_and(|material| material.surface.facts().opacity < 1.0);
        if object.material().is_some_and(is_translucent) && object.shape.refuses_interior().is_none() {
            let problem = "light is not seen through the near side of a closed surface and its far side".to_owned();
            let help = "use a disk or an open mesh, or give its material opacity = 1".to_owned();
            reader.fault(Fault { place: *place, problem, help });
        }
    }
    let sided: Vec<_> = objects.iter().filter(|(_, object)| is_sided(object, materials)).collect();
    let clear: Vec<_> = objects.iter().filter(|(_, object)| object.interior().is_some()).collect();
    if let Some((place, _)) = sided.get(MOST) {
        let problem = format!(
            "{} objects with an interior and {} closed mirrors are more than {MOST}, which a ray can be in",
            clear.len(),
            sided.len() - clear.len()
        );
        let help = "make one mesh of those that have the same medium or material".to_owned();
        reader.fault(Fault { place: *place, problem, help });
        return;
    }
    for (i, (place, second)) in clear.iter().enumerate() {
        let partly = |(_, first): &&&(Place, Object)| same_priority(first, second) && overlap_in_part(first, second);
        if let Some((first, _)) = clear[..i].iter().find(partly) {
            let problem = "this interior and another of the same priority overlap, and nothing says which is there";
            let help = format!(
                "the other is the object at line {}: give one of them a higher `priority`",
                reader.line(*first)
            );
            reader.fault(Fault { place: *place, problem: problem.to_owned(), help });
        }
    }
}

fn same_priority(first: &Object, second: &Object) -> bool {
    let Some((first, second)) = first.interior().zip(second.interior()) else { return false };
    // Two parts of one and the same medium may overlap as they like.
    first.priority == second.priority && *first.medium != *second.medium
}

/// Are some points of each one's surface inside of the other, and some outside?
fn overlap_in_part(first: &Object, second: &Object) -> bool {
    let inside = |of: &Object, other: &Object| {
        let decided = surface_points(of).into_iter().filter(|x| !touches(other, *x));
        let (within, without): (Vec<DVec3>, Vec<DVec3>) = decided.partition(|x| other.contains(*x));
        (within.len(), without.len())
    };
    let ((a_in, a_out), (b_in, b_out)) = (inside(first, second), inside(second, first));
    if a_in + a_out + b_in + b_out == 0 {
        // All of each lies on the other: they are in one place, unless they lie back to back.
        let middle = first.transform.0.translation;
        return first.contains(middle) && second.contains(middle);
    }
    let apart = a_in == 0 && b_in == 0;
    let nested = a_out == 0 || b_out == 0;
    !apart && !nested
}

fn touches(object: &Object, x: DVec3) -> bool {
    object.gap(x).is_some_and(|gap| gap.abs() <= TOUCHES * (x.length() + gap.abs()))
}

/// Points all over a surface, in the scene.
fn surface_points(object: &Object) -> Vec<DVec3> {
    let own: Vec<DVec3> = match object.shape.mesh() {
        Some(mesh) => {
            let step = mesh.triangles.len().div_ceil(POINTS).max(1);
            let corner = |i: u32| mesh.vertices[i as usize].position.as_dvec3();
            mesh.triangles.iter().step_by(step).map(|t| t.map(corner).iter().sum::<DVec3>() / 3.0).collect()
        }
        None => directions().map(|d| d / object.shape.norm(d)).collect(),
    };
    own.into_iter().map(|p| object.transform.0.transform_point3(p)).collect()
}

/// Evenly spread, as the seeds of a sunflower.
fn directions() -> impl Iterator<Item = DVec3> {
    (0..POINTS).map(|i| {
        let y = 1.0 - (2.0 * i as f64 + 1.0) / POINTS as f64;
        let (sin, cos) = (2.399_963_229_728_653 * i as f64).sin_cos();
        let ring = (1.0 - y * y).sqrt();
        DVec3::new(ring * cos, y, ring * sin)
    })
}
