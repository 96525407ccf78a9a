//! The square |x| ≤ 1, |z| ≤ 1, y = 0 with normal +y and (u, v) = ((x+1)/2, (1−z)/2).

use std::sync::Arc;

use glam::{DAffine3, DVec2, DVec3};

use super::read::upright;
use super::{CENTER, Contact, Kind, NORMAL, Placed, Primitive, Shape};
use crate::assets::Transform;
use crate::document::keys;
use crate::document::values::{array, positive_length};
use crate::model::cross_section::{LocalPlane, Outline, square};

pub static KIND: Kind = Kind {
    name: "plane",
    keys: &[
        CENTER,
        NORMAL,
        keys! { size: "[width, depth], above 0" = "2 × bounding_sphere.radius", "edge lengths, in scene units"; }[0],
    ],
    read: |table, across, _| {
        let place = upright(table, "normal");
        let edges = array("two numbers above 0, [width, depth]", positive_length);
        let size = table.or("size", DVec2::splat(across), |node| edges(node).map(DVec2::from_array));
        Some((Arc::new(Plane), place * DAffine3::from_scale(DVec3::new(size.x / 2.0, 1.0, size.y / 2.0))))
    },
};

pub static SOLID: Primitive = Primitive::listed("plane", "planes", Placed::space, true);

/// The square from −1 to 1 along x and z, in the plane y = 0; the scale of a [`Transform`] is half its edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plane;

impl Shape for Plane {
    fn solid(&self, _: &Transform) -> &'static Primitive {
        &SOLID
    }

    fn near_surface(&self, p: DVec3, slack: f64) -> bool {
        p.y.abs() <= slack && p.x.abs().max(p.z.abs()) <= 1.0
    }

    fn refuses_interior(&self) -> Option<String> {
        Some("a plane has no interior".to_owned())
    }

    fn contacts(&self, map: DAffine3) -> Vec<Contact> {
        vec![Contact::level(map)]
    }

    fn reach(&self, _: DAffine3, _: DVec3) -> Option<f64> {
        None
    }

    fn radius(&self) -> f64 {
        2.0_f64.sqrt()
    }

    fn cut(&self, plane: LocalPlane) -> Vec<Outline> {
        square(plane).into_iter().collect()
    }

    /// Returns a ball around the foot of the perpendicular from `middle`.
    fn ball_in_ball(&self, place: &Transform, middle: DVec3, center: DVec3, radius: f64) -> Option<(DVec3, f64)> {
        let map = place.0;
        let normal = map.matrix3.x_axis.cross(map.matrix3.z_axis).normalize_or_zero();
        let height = |x: DVec3| (x - map.translation).dot(normal);
        let part = (radius * radius - height(center).powi(2)).max(0.0).sqrt();
        let [foot, place] = [middle, center].map(|x| x - height(x) * normal);
        (height(center).abs() < radius).then_some((foot, part + foot.distance(place)))
    }
}
