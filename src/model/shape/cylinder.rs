//! The cylinder x² + z² ≤ 1, |y| ≤ 1 with both faces. u runs around y. v runs upwards over each of the lower face (from its center to the
//! rim), the mantle, and the upper face (from the rim to its center).

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::extent::circle;
use super::read::upright;
use super::{CENTER, Contact, Kind, Placed, Primitive, RADIUS, Shape};
use crate::assets::Transform;
use crate::document::keys;
use crate::document::values::positive_length;
use crate::model::cross_section::{LocalPlane, Outline, cylinder};
use crate::model::medium::Surroundings;

pub static KIND: Kind = Kind {
    name: "cylinder",
    keys: &[
        CENTER,
        RADIUS,
        keys! { height: "number above 0" = "2", "distance between the faces, in scene units"; }[0],
        keys! { axis: "[x, y, z]" = "[0, 1, 0]", "direction from the lower face to the upper"; }[0],
    ],
    read: |table, _, _| {
        let place = upright(table, "axis");
        let radius = table.or("radius", 1.0, positive_length);
        let height = table.or("height", 2.0, positive_length);
        Some((Arc::new(Cylinder), place * DAffine3::from_scale(DVec3::new(radius, height / 2.0, radius))))
    },
};

pub static SOLID: Primitive = Primitive::listed("cylinder", "cylinders", Placed::space, false);

/// A closed cylinder of radius 1 along y, from y = −1 to 1; the scale of a [`Transform`] is its radius and half its height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cylinder;

impl Shape for Cylinder {
    fn solid(&self, _: &Transform) -> &'static Primitive {
        &SOLID
    }

    fn faces(&self, p: DVec3) -> Vec<(f64, DVec3)> {
        let across = DVec3::new(p.x, 0.0, p.z);
        // On the axis every direction away from it is equivalent.
        vec![(across.length() - 1.0, across.normalize_or(DVec3::X)), (p.y.abs() - 1.0, DVec3::Y)]
    }

    fn contacts(&self, map: DAffine3) -> Vec<Contact> {
        let mantle = Contact::round(map, DVec3::new(1.0, 0.0, 1.0));
        Contact::ends(map, DVec3::Y).into_iter().chain([mantle]).collect()
    }

    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64> {
        Some(circle(&map, 1.0, center).max(circle(&map, -1.0, center)))
    }

    fn radius(&self) -> f64 {
        2.0_f64.sqrt()
    }

    fn cut(&self, plane: LocalPlane) -> Vec<Outline> {
        cylinder(plane).into_iter().collect()
    }

    fn norm(&self, d: DVec3) -> f64 {
        d.y.abs().max(DVec3::new(d.x, 0.0, d.z).length())
    }

    fn surroundings(&self, place: &Transform) -> Surroundings {
        let axis = Some(place.0.matrix3.y_axis.normalize());
        Surroundings { center: place.0.translation, radius: place.round_scale(), axis }
    }
}
