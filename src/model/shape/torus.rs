//! The torus about y that the unit ball holds: what is no farther than its tube's radius r from a circle of radius 1 − r. u runs round y,
//! v round the tube: from its inner side over the lower, the outer and the upper.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::extent::circle;
use super::read::upright;
use super::{CENTER, Contact, Kind, RADIUS, Shape, Solid};
use crate::assets::Transform;
use crate::document::keys;
use crate::document::values::positive;
use crate::model::cut::{CORNERS, Outline, OwnPlane};
use crate::model::halved::halved;

pub static KIND: Kind = Kind {
    name: "torus",
    keys: &[
        CENTER,
        RADIUS,
        keys! { tube: "number above 0, below the radius" = "a quarter of the radius", "the radius of its tube, about a circle of `radius`; scene units"; }
            [0],
        keys! { axis: "[x, y, z]" = "[0, 1, 0]", "what it goes round"; }[0],
    ],
    read: |table, _, _| {
        let place = upright(table, "axis");
        let radius = table.or("radius", 1.0, positive);
        let tube = table.or("tube", 0.25 * radius, positive);
        if tube >= radius {
            table.fault(&["tube"], format!("the tube must be thinner than the radius, {radius}"), "");
            return None;
        }
        let size = radius + tube;
        Some((Arc::new(Torus { tube: tube / size }), place * DAffine3::from_scale(DVec3::splat(size))))
    },
};

pub static SOLID: Solid = Solid::listed("torus", "tori", |placed| placed.space_and("tube"), false);

/// A torus about y, of radius 1 with its tube; a [`Transform`]'s scale is that radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    /// The radius of its tube, above 0 and below 1/2.
    pub tube: f64,
}

impl Torus {
    /// The radius of the circle inside of the tube.
    fn ring(self) -> f64 {
        1.0 - self.tube
    }

    /// A point of it, so far round the axis and round the tube.
    fn point(self, theta: f64, phi: f64) -> DVec3 {
        let rho = self.ring() + self.tube * phi.cos();
        DVec3::new(rho * theta.sin(), self.tube * phi.sin(), rho * theta.cos())
    }
}

impl Shape for Torus {
    fn solid(&self, _: &Transform) -> &'static Solid {
        &SOLID
    }

    fn number(&self, _: &Transform) -> f64 {
        self.tube
    }

    fn faces(&self, p: DVec3) -> Vec<(f64, DVec3)> {
        // On the axis, and on the circle inside, every direction away from it is as good.
        let away = DVec3::new(p.x, 0.0, p.z).normalize_or(DVec3::X);
        let arm = p - self.ring() * away;
        vec![(arm.length() - self.tube, arm.normalize_or(DVec3::Y))]
    }

    fn refuses_interior(&self) -> Option<String> {
        Some("a ray may cross a torus more than once".to_owned())
    }

    /// Nothing flat, nor a part of a quadric.
    fn contacts(&self, _: DAffine3) -> Vec<Contact> {
        Vec::new()
    }

    /// The circle's own, and the tube's longest radius: more than it is only where it is scaled unevenly.
    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64> {
        let ring = DAffine3 { matrix3: map.matrix3 * self.ring(), ..map };
        // The norm of Mᵀ M is no more than its longest row by absolute values, and that where axes stay across each other.
        let gram = (map.matrix3.transpose() * map.matrix3).abs();
        let longest = (gram * DVec3::ONE).max_element().sqrt();
        Some(circle(&ring, 0.0, center) + self.tube * longest)
    }

    fn radius(&self) -> f64 {
        1.0
    }

    /// The plane meets the circles round the tube, or if it is steep those round the axis, in two points each or none.
    fn cut(&self, plane: OwnPlane) -> Vec<Outline> {
        let OwnPlane { normal, offset } = plane;
        let across = normal.x.hypot(normal.z);
        let tilt = normal.x.atan2(normal.z);
        if normal.y.abs() > across {
            let met = |theta: f64| {
                let slope = across * (theta - tilt).cos();
                [(offset - self.ring() * slope) / (self.tube * slope.hypot(normal.y)), normal.y.atan2(slope)]
            };
            return outlines(met, |theta, phi| self.point(theta, phi));
        }
        let met = |phi: f64| {
            let rho = self.ring() + self.tube * phi.cos();
            [(offset - normal.y * self.tube * phi.sin()) / (across * rho), tilt]
        };
        outlines(met, |phi, theta| self.point(theta, phi))
    }

    fn bounds(&self, map: DAffine3) -> (DVec3, DVec3) {
        let rows = map.matrix3.transpose();
        let half = |row: DVec3| self.ring() * row.x.hypot(row.z) + self.tube * row.length();
        let half = DVec3::new(half(rows.x_axis), half(rows.y_axis), half(rows.z_axis));
        (map.translation - half, map.translation + half)
    }
}

/// The curves on which a family of circles meets a plane. The circle `a` meets it at b = `met(a)[1]` ± acos `met(a)[0]`, if that is a
/// cosine. Where only a part of the circles does, both signs make one curve.
fn outlines(met: impl Fn(f64) -> [f64; 2], point: impl Fn(f64, f64) -> DVec3) -> Vec<Outline> {
    const HALVINGS: u32 = 40;
    let step = TAU / f64::from(CORNERS);
    let is_met = |a: f64| met(a)[0].abs() <= 1.0;
    let on = |a: f64, side: f64| {
        let [cosine, middle] = met(a);
        point(a, middle + side * cosine.clamp(-1.0, 1.0).acos())
    };
    let at = |i: u32| step * f64::from(i);
    let Some(missed) = (0..CORNERS).find(|i| !is_met(at(*i))) else {
        let whole = |side: f64| Outline { points: (0..CORNERS).map(|i| on(at(i), side)).collect(), closed: true };
        return [1.0, -1.0].map(whole).into();
    };
    let all: Vec<f64> = (missed..=missed + CORNERS).map(at).collect();
    let runs = all.chunk_by(|a, b| is_met(*a) == is_met(*b)).filter(|run| is_met(run[0]));
    let curve = |run: &[f64]| {
        let (first, last) = (run[0], run[run.len() - 1]);
        let from = halved(first - step, first, HALVINGS, is_met)[1];
        let to = halved(last, last + step, HALVINGS, |a| !is_met(a))[0];
        let way: Vec<f64> = [from].into_iter().chain(run.iter().copied()).chain([to]).collect();
        let there = way.iter().map(|a| on(*a, 1.0));
        Outline { points: there.chain(way.iter().rev().map(|a| on(*a, -1.0))).collect(), closed: true }
    };
    runs.map(curve).collect()
}
