//! `[[objects]]`: shapes, where they are and what they are made of.

use super::bounds;
use super::files::Files;
use super::media::{self, Surroundings};
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{
    Read, array, direction, extents, not_negative, positive, suggest, text, vector, whole, word,
};
use crate::scene::document::{Node, Place, Value};
use crate::scene::{Bound, Interior, Object, Shape, Substance, Transform};
use glam::{DAffine3, DQuat, DVec2, DVec3};

#[derive(Clone, Copy)]
enum Name {
    Sphere,
    Plane,
    Box,
    Cylinder,
    Disk,
    Mesh,
}

const NAMES: &[(&str, Name)] = &[
    ("sphere", Name::Sphere),
    ("plane", Name::Plane),
    ("box", Name::Box),
    ("cylinder", Name::Cylinder),
    ("disk", Name::Disk),
    ("mesh", Name::Mesh),
];

/// All objects that can be used, each with its place, in the order of the file; `materials` are the names of the materials.
pub fn read(root: &TableReader, materials: &[&str], bound: Option<Bound>, files: &mut Files) -> Vec<(Place, Object)> {
    let tables = root.subtables("objects", "objects").into_iter();
    tables
        .filter_map(|table| {
            let object = object(&table, materials, bound, files);
            let place = table.place;
            table.finish();
            Some((place, object?))
        })
        .collect()
}

fn object(table: &TableReader, materials: &[&str], bound: Option<Bound>, files: &mut Files) -> Option<Object> {
    let name = table.decide_required("shape", "\"sphere\"", word(NAMES, &[]));
    let shape = name.and_then(|name| shape(table, name, bound, files));
    let translate = table.or("translate", DVec3::ZERO, vector);
    let rotate = table.or("rotate", DVec3::ZERO, vector);
    let scale = table.or("scale", DVec3::ONE, |node| match node.value {
        Value::Array(_) => extents(node),
        _ => positive(node).map(DVec3::splat),
    });
    let place = shape.as_ref().map(|(_, own)| Transform(Transform::new(scale, rotate, translate).0 * *own));
    let substance = substance(table, shape.as_ref().map(|(shape, _)| shape).zip(place), materials, files);
    let (shape, _) = shape?;
    let transform = place?;
    if let Some(bound) = bound {
        check_inside(table, &shape, transform, bound);
    }
    Some(Object { shape, transform, substance: substance? })
}

/// A material by name, or a medium inside.
fn substance(
    table: &TableReader,
    object: Option<(&Shape, Transform)>,
    materials: &[&str],
    files: &mut Files,
) -> Option<Substance> {
    let Some(("interior", node)) = table.one_of(&["material", "interior"]) else {
        return table.required("material", "\"red\"", |node| material(node, materials)).map(Substance::Opaque);
    };
    let around = object.map_or_else(Surroundings::default, |(shape, place)| surroundings(shape, place));
    let medium = media::read(table, node, "medium", around, files);
    let priority = table.or("priority", 0, whole(0..=1000));
    if let Some((shape, _)) = object {
        check_closed(table, shape);
    }
    medium.map(|medium| Substance::Clear(Interior { medium, priority }))
}

fn material(node: &Node, materials: &[&str]) -> Read<usize> {
    let name = text(node)?;
    let unknown = || match materials {
        [] => node.fault(format!("there is no material `{name}`"), format!("add [materials.{name}]")),
        _ => node.fault(format!("there is no material `{name}`"), suggest(name, materials, "materials")),
    };
    materials.iter().position(|known| *known == name).ok_or_else(unknown)
}

/// What a medium in the object takes its place and size from.
fn surroundings(shape: &Shape, place: Transform) -> Surroundings {
    let (radius, axis) = match shape {
        Shape::Sphere => (place.uniform_scale(), None),
        Shape::Cylinder => (place.round_scale(), Some(place.0.matrix3.y_axis.normalize())),
        _ => (None, None),
    };
    Surroundings { center: place.0.translation, radius, axis }
}

fn check_closed(table: &TableReader, shape: &Shape) {
    let open = match shape {
        Shape::Plane => Some("a plane has no inside".to_owned()),
        Shape::Disk { .. } => Some("a disk has no inside".to_owned()),
        Shape::Mesh(mesh) => mesh.hole().map(|[a, b, c]| {
            format!("the mesh is not closed: an edge at [{a:.4}, {b:.4}, {c:.4}] has not two triangles of one sense")
        }),
        Shape::Sphere | Shape::Box | Shape::Cylinder => None,
    };
    if let Some(problem) = open {
        table.fault(&["interior"], problem, "give it a material, or close it");
    }
}

/// The shape in its own space, and the map from there that its own keys make.
fn shape(table: &TableReader, name: Name, bound: Option<Bound>, files: &mut Files) -> Option<(Shape, DAffine3)> {
    match name {
        Name::Sphere => {
            let center = table.or("center", DVec3::ZERO, vector);
            let radius = DVec3::splat(table.or("radius", 1.0, positive));
            let own = DAffine3::from_scale_rotation_translation(radius, DQuat::IDENTITY, center);
            Some((Shape::Sphere, own))
        }
        Name::Plane => Some((Shape::Plane, plane(table, bound))),
        Name::Box => Some((Shape::Box, cuboid(table)?)),
        Name::Cylinder => {
            let place = upright(table, "axis");
            let radius = table.or("radius", 1.0, positive);
            let height = table.or("height", 2.0, positive);
            Some((Shape::Cylinder, place * DAffine3::from_scale(DVec3::new(radius, height / 2.0, radius))))
        }
        Name::Disk => {
            let place = upright(table, "normal");
            let radius = table.or("radius", 1.0, positive);
            let hole = table.or("hole", 0.0, not_negative);
            if hole >= radius {
                table.fault(&["hole"], format!("the hole must be smaller than the radius, {radius}"), "");
                return None;
            }
            Some((Shape::Disk { hole: hole / radius }, place * DAffine3::from_scale(DVec3::splat(radius))))
        }
        Name::Mesh => {
            let file = table.required_node("file", "\"teapot.obj\"")?;
            let mesh = files.mesh(table.reader, file)?;
            Some((Shape::Mesh(mesh), DAffine3::IDENTITY))
        }
    }
}

fn plane(table: &TableReader, bound: Option<Bound>) -> DAffine3 {
    let place = upright(table, "normal");
    let across = DVec2::splat(2.0 * bound.map_or(1.0, |bound| bound.radius));
    let size = table
        .or("size", across, |node| array("two numbers above 0, [width, depth]", positive)(node).map(DVec2::from_array));
    place * DAffine3::from_scale(DVec3::new(size.x / 2.0, 1.0, size.y / 2.0))
}

/// To `center`, turned so that y goes where `key` says.
fn upright(table: &TableReader, key: &'static str) -> DAffine3 {
    let center = table.or("center", DVec3::ZERO, vector);
    let rotation = DQuat::from_rotation_arc(DVec3::Y, table.or(key, DVec3::Y, direction));
    DAffine3::from_rotation_translation(rotation, center)
}

/// From center and size, or from min and max.
fn cuboid(table: &TableReader) -> Option<DAffine3> {
    let corners = (table.optional("min", vector), table.optional("max", vector));
    let center = table.optional("center", vector);
    let size = table.optional("size", extents);
    let (center, size) = match (corners, center.is_some() || size.is_some()) {
        ((None, None), _) => (center.unwrap_or(DVec3::ZERO), size.unwrap_or(DVec3::ONE)),
        (_, true) => {
            let problem = "a box has `center` and `size`, or `min` and `max`, not both";
            table.fault(&["min", "max"], problem, "");
            return None;
        }
        ((Some(min), Some(max)), _) if min.cmplt(max).all() => ((min + max) / 2.0, max - min),
        ((Some(_), Some(_)), _) => {
            let problem = "`max` must be above `min` in x, y and z";
            table.fault(&["max"], problem, "");
            return None;
        }
        _ => {
            let problem = "`min` and `max` go together";
            table.fault(&["min", "max"], problem, "");
            return None;
        }
    };
    let half = size / 2.0;
    Some(DAffine3::from_scale_rotation_translation(half, DQuat::IDENTITY, center))
}

fn check_inside(table: &TableReader, shape: &Shape, transform: Transform, bound: Bound) {
    let Some(reach) = bounds::reach(shape, transform, bound.center) else {
        return;
    };
    if reach > bound.radius * (1.0 + 1e-9) {
        let beyond = bounds::round_up(reach - bound.radius);
        let problem = format!("the object reaches {beyond} beyond the bound, where rays do not come");
        let enough = bounds::round_up(reach);
        let help = format!("a radius of {enough} would do in rays.bound");
        table.fault(&["shape"], problem, help);
    }
}
