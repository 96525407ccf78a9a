//! The reader of `[[objects]]`.

use glam::{DAffine3, DQuat, DVec3};

use super::{KINDS, Object, Shape, Substance, ball, rigid_motion, round_up};
use crate::assets::{Files, Transform};
use crate::document::reader::TableReader;
use crate::document::values::{Parsed, angles, direction, extents, point, positive, suggest, text, whole};
use crate::document::{Node, Span, Value};
use crate::model::medium::{self, Interior, Surroundings};
use crate::model::{Law, Material};

/// The bounding spheres: their centers (two if a throat leads to another side) and their radius.
type Balls<'a> = (&'a [DVec3], f64);

/// The names of all materials, and the materials without errors.
type Materials<'a> = (&'a [&'a str], &'a [Material]);

/// Reads all objects without errors, each with its index in the file.
pub(crate) fn read(
    root: &TableReader,
    materials: Materials,
    bound: Option<Balls>,
    law: Option<&dyn Law>,
    files: &mut Files,
) -> Vec<(Span, Object)> {
    let tables = root.subtables("objects", "objects").into_iter();
    tables
        .filter_map(|table| {
            let object = object(&table, materials, bound, law, files);
            let place = table.place;
            table.finish();
            Some((place, object?))
        })
        .collect()
}

fn object(
    table: &TableReader,
    materials: Materials,
    bound: Option<Balls>,
    law: Option<&dyn Law>,
    files: &mut Files,
) -> Option<Object> {
    let across = 2.0 * bound.map_or(1.0, |(_, radius)| radius);
    let shape = KINDS.chosen(table).and_then(|read| read(table, across, files));
    let translate = table.or("translate", DVec3::ZERO, point);
    let rotate = table.or("rotate", DVec3::ZERO, angles);
    let scale = table.or("scale", DVec3::ONE, |node| match node.value {
        Value::Array(_) => extents(node),
        _ => positive(node).map(DVec3::splat),
    });
    let place = shape.as_ref().map(|(_, own)| Transform(Transform::new(scale, rotate, translate).0 * *own));
    let substance = substance(table, shape.as_ref().map(|(shape, _)| &**shape).zip(place), materials, files);
    let (shape, _) = shape?;
    let transform = place?;
    let travel = rigid_motion::read(table, law, Some(ball(shape.radius(), &transform).0));
    if travel.is_some() && shape.mesh().is_some() {
        table.fault(&["orbit", "velocity"], "meshes cannot move", "use a shape that is not a mesh");
    }
    if let Some((centers, radius)) = bound {
        let reach = |center: &DVec3| match travel {
            Some(travel) => travel.farthest(ball(shape.radius(), &transform), *center),
            None => shape.reach(transform.0, *center),
        };
        check_inside(table, centers.iter().filter_map(reach), radius);
    }
    Some(Object { shape, transform, substance: substance?, travel })
}

/// Reads the name of a material, or an interior medium.
fn substance(
    table: &TableReader,
    object: Option<(&dyn Shape, Transform)>,
    materials: Materials,
    files: &mut Files,
) -> Option<Substance> {
    let Some(("interior", node)) = table.one_of(&["material", "interior"]) else {
        let index = table.required("material", "\"red\"", |node| material(node, materials.0))?;
        if let Some((shape, _)) = object {
            check_vertex_colors(table, shape, materials.0[index], materials.1);
        }
        return Some(Substance::Opaque(index));
    };
    let around = object.map_or_else(Surroundings::default, |(shape, place)| shape.surroundings(&place));
    let interior = medium::read_interior(table, node, around, files);
    let priority = table.or("priority", 0, whole(0..=1000));
    if let Some(problem) = object.and_then(|(shape, _)| shape.refuses_interior()) {
        table.fault(&["interior"], problem, "set `material`, or use another shape, such as a closed mesh");
    }
    interior.map(|interior| Substance::TransparentShadows(Interior { priority, ..interior }))
}

/// Reports a material with vertex colors on an object without them.
fn check_vertex_colors(table: &TableReader, shape: &dyn Shape, name: &str, materials: &[Material]) {
    let asks = |material: &Material| material.name == name && material.color.has_vertex_colors();
    if !materials.iter().any(asks) {
        return;
    }
    let lacks =
        shape.mesh().map_or_else(|| Some("only meshes have vertex colors".to_owned()), |mesh| mesh.lacks_colors());
    if let Some(lacks) = lacks {
        let problem = format!("the material `{name}` has `vertex_colors = true`, but {lacks}");
        let help = "remove `vertex_colors` there, or use a mesh with vertex colors: lines `v x y z red green blue` in \
                    OBJ, vertex properties `red`, `green` and `blue` in PLY, or `COLOR_0` in glTF";
        table.fault(&["material"], problem, help);
    }
}

fn material(node: &Node, materials: &[&str]) -> Parsed<usize> {
    let name = text(node)?;
    let unknown = || match materials {
        [] => node.fault(format!("unknown material `{name}`"), format!("add [materials.{name}]")),
        _ => node.fault(format!("unknown material `{name}`"), suggest(name, materials, "materials")),
    };
    materials.iter().position(|known| *known == name).ok_or_else(unknown)
}

/// Returns the map to `center` with y in the direction of `key`.
pub(super) fn upright(table: &TableReader, key: &'static str) -> DAffine3 {
    let center = table.or("center", DVec3::ZERO, point);
    let rotation = DQuat::from_rotation_arc(DVec3::Y, table.or(key, DVec3::Y, direction));
    DAffine3::from_rotation_translation(rotation, center)
}

/// Checks that the extent from the center of a bounding sphere is within its radius.
fn check_inside(table: &TableReader, reaches: impl Iterator<Item = f64>, radius: f64) {
    let Some(reach) = reaches.min_by(f64::total_cmp) else {
        return;
    };
    if reach > radius * (1.0 + 1e-9) {
        let beyond = round_up(reach - radius);
        let problem = format!("the object extends {beyond} beyond the bounding sphere, where no rays are traced");
        let enough = round_up(reach);
        let help = format!("use a radius of at least {enough} in rays.bounding_sphere");
        table.fault(&["shape"], problem, help);
    }
}
