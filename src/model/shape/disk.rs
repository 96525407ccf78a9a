//! The disk x² + z² ≤ 1, y = 0 with normal +y. u runs around y, v from the outer rim to the center or the inner rim.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::read::upright;
use super::{CENTER, Contact, Kind, NORMAL, Primitive, RADIUS, Shape, extent};
use crate::assets::Transform;
use crate::document::keys;
use crate::document::values::{not_negative_length, positive_length};
use crate::model::cross_section::{LocalPlane, ON, Outline, PARALLEL, circle};

pub static KIND: Kind = Kind {
    name: "disk",
    keys: &[
        CENTER,
        NORMAL,
        RADIUS,
        keys! { inner_radius: "number, 0 or above, below the radius" = "0", "radius of the hole, in scene units"; }[0],
    ],
    read: |table, _, _| {
        let place = upright(table, "normal");
        let radius = table.or("radius", 1.0, positive_length);
        let hole = table.or("inner_radius", 0.0, not_negative_length);
        if hole >= radius {
            table.fault(&["inner_radius"], format!("expected an inner radius less than the radius, {radius}"), "");
            return None;
        }
        Some((Arc::new(Disk { hole: hole / radius }), place * DAffine3::from_scale(DVec3::splat(radius))))
    },
};

pub static SOLID: Primitive = Primitive::listed("disk", "disks", |placed| placed.space_and("hole"), true);

/// The disk of radius 1 around the origin in the plane y = 0; the scale of a [`Transform`] is its radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disk {
    /// The radius of a round hole in the disk, below 1; zero without a hole.
    pub hole: f64,
}

impl Shape for Disk {
    fn solid(&self, _: &Transform) -> &'static Primitive {
        &SOLID
    }

    fn number(&self, _: &Transform) -> f64 {
        self.hole
    }

    fn near_surface(&self, p: DVec3, slack: f64) -> bool {
        let rho = p.x.hypot(p.z);
        p.y.abs() <= slack && rho <= 1.0 && rho >= self.hole
    }

    fn refuses_interior(&self) -> Option<String> {
        Some("a disk has no interior".to_owned())
    }

    fn contacts(&self, map: DAffine3) -> Vec<Contact> {
        vec![Contact::level(map)]
    }

    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64> {
        Some(extent::circle(&map, 0.0, center))
    }

    fn radius(&self) -> f64 {
        1.0
    }

    /// Returns one line, or two if the plane crosses the hole, or the edges if the disk is in the plane.
    fn cut(&self, plane: LocalPlane) -> Vec<Outline> {
        let slope = DVec3::new(plane.normal.x, 0.0, plane.normal.z);
        if slope.length() <= PARALLEL {
            let edges = [1.0, self.hole].into_iter().filter(|radius| *radius > 0.0 && plane.offset.abs() <= ON);
            return edges.map(|radius| circle(DVec3::ZERO, DVec3::Y, radius)).collect();
        }
        let foot = slope * (plane.offset / slope.length_squared());
        let along = slope.cross(DVec3::Y).normalize();
        let half = |radius: f64| (radius * radius - foot.length_squared()).max(0.0).sqrt();
        let (outer, inner) = (half(1.0), half(self.hole));
        let stretches = if inner > 0.0 { vec![[-outer, -inner], [inner, outer]] } else { vec![[-outer, outer]] };
        let line = |ends: [f64; 2]| Outline { points: ends.map(|t| foot + t * along).to_vec(), closed: false };
        stretches.into_iter().filter(|[from, to]| from < to).map(line).collect()
    }
}
