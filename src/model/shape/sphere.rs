//! The unit sphere, with u around y and v from the south to the north pole. A non-uniform scale makes it an ellipsoid.

use std::sync::Arc;

use glam::{DAffine3, DQuat, DVec3};

use super::extent::ellipsoid;
use super::{CENTER, Contact, Kind, Placed, Primitive, RADIUS, Shape};
use crate::assets::Transform;
use crate::document::values::{point, positive_length};
use crate::model::cross_section::{LocalPlane, Outline, circle};
use crate::model::medium::Surroundings;

pub static KIND: Kind = Kind {
    name: "sphere",
    keys: &[CENTER, RADIUS],
    read: |table, _, _| {
        let center = table.or("center", DVec3::ZERO, point);
        let radius = DVec3::splat(table.or("radius", 1.0, positive_length));
        let own = DAffine3::from_scale_rotation_translation(radius, DQuat::IDENTITY, center);
        Some((Arc::new(Sphere), own))
    },
};

pub static SOLID: Primitive = Primitive::listed("sphere", "spheres", Placed::ball, false);

pub static ELLIPSOID: Primitive = Primitive::listed("ellipsoid", "ellipsoids", Placed::space, false);

/// The sphere of radius 1 around the origin; the scale of a [`Transform`] is its radius, or the half axes of an ellipsoid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sphere;

impl Shape for Sphere {
    fn solid(&self, place: &Transform) -> &'static Primitive {
        if place.uniform_scale().is_some() { &SOLID } else { &ELLIPSOID }
    }

    fn number(&self, place: &Transform) -> f64 {
        place.uniform_scale().unwrap_or(0.0)
    }

    fn faces(&self, p: DVec3) -> Vec<(f64, DVec3)> {
        // At the center every direction away from it is equivalent.
        vec![(p.length() - 1.0, p.normalize_or(DVec3::X))]
    }

    fn contacts(&self, map: DAffine3) -> Vec<Contact> {
        vec![Contact::round(map, DVec3::ONE)]
    }

    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64> {
        Some(ellipsoid(&map, center))
    }

    fn radius(&self) -> f64 {
        1.0
    }

    fn cut(&self, plane: LocalPlane) -> Vec<Outline> {
        let radius = (1.0 - plane.offset * plane.offset).sqrt();
        let outline = || circle(plane.normal * plane.offset, plane.normal, radius);
        (radius > 0.0).then(outline).into_iter().collect()
    }

    fn surroundings(&self, place: &Transform) -> Surroundings {
        Surroundings { center: place.0.translation, radius: place.uniform_scale(), axis: None }
    }

    fn ball_radius(&self, place: &Transform) -> Option<f64> {
        place.uniform_scale()
    }

    fn holds_ball(&self, place: &Transform, center: DVec3, radius: f64) -> bool {
        place.uniform_scale().is_some_and(|own| center.distance(place.0.translation) + radius <= own)
    }

    fn ball_inside(&self, place: &Transform, center: DVec3) -> f64 {
        place.uniform_scale().map_or(0.0, |radius| radius - center.distance(place.0.translation))
    }
}
