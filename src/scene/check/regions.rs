//! The check of interiors: overlapping interiors need a priority, and the number of objects with an inside is limited.
//!
//! If one object is inside another, the inner one wins without a priority. If two of equal priority overlap partially or coincide, the
//! scene is ambiguous. Points on each surface detect this, so that an overlap smaller than their spacing may be missed.

use crate::document::reader::Reader;
use crate::document::{Span, SpannedError};
use crate::model::{Material, Object, Substance};
use glam::DVec3;

/// The largest number of objects with an inside: a ray stores the objects that contain it in this many bits, including closed mirrors.
const MOST: usize = 32;
/// The number of points on a surface.
const POINTS: usize = 400;
/// The distance, relative to the distance from the origin, below which a point counts as on a surface.
const TOUCHES: f64 = 1e-6;

/// Replaces objects whose side rays track by their solids. Additional solids of an object come last, so that the indices of all other
/// objects remain those of the file.
pub fn solids(objects: Vec<(Span, Object)>, materials: &[Material]) -> Vec<(Span, Object)> {
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

/// Returns `true` if rays track their side of the surface.
fn is_sided(object: &Object, materials: &[Material]) -> bool {
    let continues = |i: usize| materials.get(i).is_some_and(|material| material.surface.facts().continues);
    match object.substance {
        Substance::TransparentShadows(_) => true,
        Substance::Opaque(material) => continues(material) && object.shape.refuses_interior().is_none(),
    }
}

/// Reports errors of the interiors of objects, each with its location in the file.
pub fn check(reader: &Reader, objects: &[(Span, Object)], materials: &[Material]) {
    for (place, object) in objects {
        let is_translucent = |i: usize| materials.get(i).is_some_and(|material| material.surface.facts().opacity < 1.0);
        if object.material().is_some_and(is_translucent) && object.shape.refuses_interior().is_none() {
            let problem = "a closed surface cannot be translucent".to_owned();
            let help = "use a disk or an open mesh, or give its material opacity = 1".to_owned();
            reader.fault(SpannedError { place: *place, problem, help });
        }
    }
    let sided: Vec<_> = objects.iter().filter(|(_, object)| is_sided(object, materials)).collect();
    let clear: Vec<_> = objects.iter().filter(|(_, object)| object.interior().is_some()).collect();
    if let Some((place, _)) = sided.get(MOST) {
        let problem = format!(
            "{} objects with an interior and {} closed mirrors exceed the limit of {MOST}",
            clear.len(),
            sided.len() - clear.len()
        );
        let help = "merge those with the same medium or material into one mesh".to_owned();
        reader.fault(SpannedError { place: *place, problem, help });
        return;
    }
    for (i, (place, second)) in clear.iter().enumerate() {
        let partly = |(_, first): &&&(Span, Object)| same_priority(first, second) && overlap_in_part(first, second);
        if let Some((first, _)) = clear[..i].iter().find(partly) {
            let problem = "this interior overlaps a different one of the same priority";
            let help =
                format!("give one of them a higher `priority`; the other object is at line {}", reader.line(*first));
            reader.fault(SpannedError { place: *place, problem: problem.to_owned(), help });
        }
    }
}

fn same_priority(first: &Object, second: &Object) -> bool {
    let Some((first, second)) = first.interior().zip(second.interior()) else { return false };
    // Two regions of one medium may overlap.
    first.priority == second.priority && *first.medium != *second.medium
}

/// Returns `true` if each surface has points inside and outside the other object.
fn overlap_in_part(first: &Object, second: &Object) -> bool {
    let inside = |of: &Object, other: &Object| {
        let decided = surface_points(of).into_iter().filter(|x| !touches(other, *x));
        let (within, without): (Vec<DVec3>, Vec<DVec3>) = decided.partition(|x| other.contains(*x));
        (within.len(), without.len())
    };
    let ((a_in, a_out), (b_in, b_out)) = (inside(first, second), inside(second, first));
    if a_in + a_out + b_in + b_out == 0 {
        // If all points of each surface are on the other, the objects coincide, unless they touch from opposite sides.
        let middle = first.transform.0.translation;
        return first.contains(middle) && second.contains(middle);
    }
    let apart = a_in == 0 && b_in == 0;
    let nested = a_out == 0 || b_out == 0;
    !apart && !nested
}

fn touches(object: &Object, x: DVec3) -> bool {
    object
        .signed_distance(x)
        .is_some_and(|signed_distance| signed_distance.abs() <= TOUCHES * (x.length() + signed_distance.abs()))
}

/// Returns points distributed over a surface, in scene coordinates.
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

/// Returns evenly distributed directions on a Fibonacci spiral.
fn directions() -> impl Iterator<Item = DVec3> {
    (0..POINTS).map(|i| {
        let y = 1.0 - (2.0 * i as f64 + 1.0) / POINTS as f64;
        let (sin, cos) = (2.399_963_229_728_653 * i as f64).sin_cos();
        let ring = (1.0 - y * y).sqrt();
        DVec3::new(ring * cos, y, ring * sin)
    })
}
