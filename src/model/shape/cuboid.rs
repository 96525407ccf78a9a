//! The cube |x|, |y|, |z| ≤ 1, with (u, v) in [0, 1] on each face.

use std::sync::Arc;

use glam::{DAffine3, DQuat, DVec3};

use super::{CENTER, Contact, Kind, Placed, Primitive, Shape};
use crate::assets::Transform;
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{edges, point};
use crate::model::cross_section::{LocalPlane, Outline, cuboid};

pub static KIND: Kind = Kind {
    name: "box",
    keys: &[
        CENTER,
        keys! { size: "[x, y, z], above 0" = "[1, 1, 1]", "edge lengths, in scene units"; }[0],
        keys! { min: "[x, y, z]" = "none", "lowest corner, in scene units, with max; instead of center and size"; }[0],
        keys! { max: "[x, y, z]" = "none", "highest corner, in scene units"; }[0],
    ],
    read: |table, _, _| Some((Arc::new(Cuboid), place(table)?)),
};

/// Reads the placement from center and size, or from min and max.
fn place(table: &TableReader) -> Option<DAffine3> {
    let corners = (table.optional("min", point), table.optional("max", point));
    let center = table.optional("center", point);
    let size = table.optional("size", edges);
    let refuse = |keys: &[&str], problem: &str| {
        table.fault(keys, problem, "");
        None
    };
    let (center, size) = match (corners, center.is_some() || size.is_some()) {
        ((None, None), _) => (center.unwrap_or(DVec3::ZERO), size.unwrap_or(DVec3::ONE)),
        (_, true) => return refuse(&["min", "max"], "a box has either `center` and `size`, or `min` and `max`"),
        ((Some(min), Some(max)), _) if min.cmplt(max).all() => ((min + max) / 2.0, max - min),
        ((Some(_), Some(_)), _) => return refuse(&["max"], "`max` must be above `min` in x, y and z"),
        _ => return refuse(&["min", "max"], "`min` and `max` must be given together"),
    };
    Some(DAffine3::from_scale_rotation_translation(size / 2.0, DQuat::IDENTITY, center))
}

pub static SOLID: Primitive = Primitive::listed("box", "boxes", Placed::space, false);

/// The box from −1 to 1 along each axis; the scale of a [`Transform`] is half its edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cuboid;

impl Shape for Cuboid {
    fn solid(&self, _: &Transform) -> &'static Primitive {
        &SOLID
    }

    fn faces(&self, p: DVec3) -> Vec<(f64, DVec3)> {
        let flat = |coordinate: f64, axis: DVec3| (coordinate.abs() - 1.0, axis);
        vec![flat(p.x, DVec3::X), flat(p.y, DVec3::Y), flat(p.z, DVec3::Z)]
    }

    fn contacts(&self, map: DAffine3) -> Vec<Contact> {
        DVec3::AXES.into_iter().flat_map(|axis| Contact::ends(map, axis)).collect()
    }

    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64> {
        let corner = |i: u32| DVec3::from_array([0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -1.0 } else { 1.0 }));
        Some((0..8).map(corner).map(|p| map.transform_point3(p).distance(center)).fold(0.0, f64::max))
    }

    fn radius(&self) -> f64 {
        3.0_f64.sqrt()
    }

    fn cut(&self, plane: LocalPlane) -> Vec<Outline> {
        cuboid(plane).into_iter().collect()
    }

    fn norm(&self, d: DVec3) -> f64 {
        d.abs().max_element()
    }

    fn ball_inside(&self, place: &Transform, center: DVec3) -> f64 {
        let inverse = place.0.inverse();
        let own = inverse.transform_point3(center);
        let [x, y, z] = inverse.matrix3.transpose().to_cols_array_2d().map(|row| DVec3::from(row).length());
        ((DVec3::ONE - own.abs()) / DVec3::new(x, y, z)).min_element()
    }
}
