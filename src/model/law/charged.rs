//! A black hole with charge and without spin (Reissner and Nordström), also where space has a cosmological constant (Kottler).
//!
//! *Theory.* ds² = −A dt² + dr²/A + r² dΩ² with A = 1 − 2M/r + Q²/r² − Λr²/3. As round a Schwarzschild hole paths follow from Binet's
//! equation, here u″ + u = 3Mu² − 2Q²u³; Λ drops out of it, and shows in what observers see alone.
//!
//! *Practice.* The same hole is `kerr-newman` without spin. This law is of second order and in a plane, and many times as fast.

use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::observer::{OBSERVER_PART, RoundHole};
use super::{CameraFrame, Invariant, Kind, Landmark, Law, Orbit, OrbitForm, Order};
use crate::document::keys;
use crate::document::values::{direction, number, positive, vector};
use crate::model::{Anchor, Binding, Capture, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "reissner-nordstrom",
    keys: keys! {
        mass: "number above 0" = "1", "M, scene units (G = c = 1)";
        charge: "number" = "0", "Q, scene units: above M there is no horizon, and nothing is captured";
        cosmological: "number" = "0", "Λ, in one over scene units squared: it changes what observers see, and no path";
        center: "[x, y, z]" = "[0, 0, 0]", "the hole's place";
        axis: "[x, y, z]" = "[0, 0, 1]", "what matter and observers on orbits go round, anticlockwise seen from its tip";
    },
    read: |table, _| {
        let hole = ChargedHole {
            mass: table.or("mass", 1.0, positive),
            charge: table.or("charge", 0.0, number),
            cosmological: table.or("cosmological", 0.0, number),
            center: table.or("center", DVec3::ZERO, vector),
            axis: table.or("axis", DVec3::Z, direction),
        };
        if hole.photon_sphere().is_some_and(|r| hole.clock(r) <= 0.0) {
            let most = hole.cosmological_most();
            table.fault(
                &["cosmological"],
                "no place outside of this hole is at rest",
                format!("use less than {most:.6}"),
            );
        }
        Some(Arc::new(hole))
    },
};

/// A black hole with charge and without spin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChargedHole {
    /// M, scene units (G = c = 1).
    pub mass: f64,
    /// Q, scene units.
    pub charge: f64,
    /// Λ.
    pub cosmological: f64,
    /// The hole's place.
    pub center: DVec3,
    /// The unit vector that matter and observers on orbits go round.
    pub axis: DVec3,
}

impl ChargedHole {
    /// A of the line element, which is −`g_tt`, at a distance r.
    #[must_use]
    pub fn clock(&self, r: f64) -> f64 {
        1.0 - 2.0 * self.mass / r + (self.charge / r).powi(2) - self.cosmological * r * r / 3.0
    }

    fn round(&self, x: DVec3) -> RoundHole {
        let offset = x - self.center;
        let r = offset.length();
        let slope = 2.0 * (self.mass - self.charge * self.charge / r) / (r * r) - 2.0 * self.cosmological * r / 3.0;
        let photon_sphere = self.photon_sphere().unwrap_or(0.0);
        RoundHole { offset, axis: self.axis, clock: self.clock(r), slope, photon_sphere }
    }

    /// r where light goes round in circles, and what moves inwards below it never comes back; none without a horizon.
    #[must_use]
    pub fn photon_sphere(&self) -> Option<f64> {
        let root = (9.0 * self.mass * self.mass - 8.0 * self.charge * self.charge).sqrt();
        (self.charge.abs() <= self.mass).then_some(0.5 * (3.0 * self.mass + root))
    }

    /// Λ from which on A is above 0 nowhere.
    fn cosmological_most(&self) -> f64 {
        let flat = Self { cosmological: 0.0, ..*self };
        self.photon_sphere().map_or(0.0, |r| 3.0 * flat.clock(r) / (r * r))
    }

    /// r of the horizon, if there is one: where A vanishes below the photon sphere, by halving.
    #[must_use]
    pub fn horizon(&self) -> Option<f64> {
        let mut high = self.photon_sphere()?;
        // A is least below 0 where Q² = Mr; without charge it has no least value.
        let mut low = (self.charge * self.charge / self.mass).max(1e-6 * self.mass);
        for _ in 0..100 {
            let middle = low.midpoint(high);
            *(if self.clock(middle) > 0.0 { &mut high } else { &mut low }) = middle;
        }
        Some(high)
    }
}

impl Law for ChargedHole {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["law/accelerated", "law/start_as_given", "law/projected_as_is", "law/charged_path"])
    }

    fn values(&self) -> Vec<Binding> {
        let row = row! {
            center: Vec3(self.center),
            mass: Float(self.mass),
            charge_squared: Float(self.charge * self.charge),
            third: Float(self.cosmological / 3.0),
        };
        vec![Binding::one("law", row)]
    }

    fn order(&self) -> Order {
        Order::Place
    }

    /// At the horizon, or as far out as the photon sphere where nothing lies between that a ray moving inwards could still hit.
    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let (Some(sphere), Some(horizon)) = (self.photon_sphere(), self.horizon()) else { return Vec::new() };
        let is_clear = clearance.is_some_and(|clearance| clearance(self.center) > sphere);
        vec![Capture { anchor: Anchor::center(self.center), radius: if is_clear { sphere } else { horizon } }]
    }

    fn orbit(&self) -> Option<Orbit> {
        Some(Orbit { center: self.center, form: OrbitForm::Plane("law/orbit/charged"), is_free_far_away: true })
    }

    /// h = |x × v| and E² = ṙ² + (1 − 2M/r + Q²/r²) h²/r², which together are the null condition: Λ only adds to it what h keeps.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let d = x - self.center;
        let (r, momentum) = (d.length(), d.cross(v).length());
        let clock = Self { cosmological: 0.0, ..*self }.clock(r);
        let energy = ((d.dot(v) / r).powi(2) + clock * (momentum / r).powi(2)).sqrt();
        vec![
            Invariant { name: "angular momentum", value: momentum, size: r * v.length() },
            Invariant { name: "energy", value: energy, size: v.length() },
        ]
    }

    fn landmarks(&self) -> Vec<Landmark> {
        let horizon = |radius| Landmark::sphere("horizon", self.center, radius, true);
        self.horizon().map(horizon).into_iter().collect()
    }

    fn remark(&self, _: DVec3, _: f64) -> Option<String> {
        let remark = || "the hole has no horizon, for Q is above M: its singularity is naked, and repels".to_owned();
        self.horizon().is_none().then(remark)
    }

    fn frame_part(&self, frame: CameraFrame) -> Option<&'static str> {
        RoundHole::knows(frame).then_some(OBSERVER_PART)
    }

    fn metric(&self, x: DVec3) -> Option<DMat4> {
        Some(self.round(x).metric())
    }

    fn length_scale(&self, x: DVec3) -> f64 {
        x.distance(self.center)
    }

    fn observer(&self, frame: CameraFrame, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        self.round(at).observer(frame)
    }

    fn equator(&self) -> Option<[DVec3; 2]> {
        Some([self.center, self.axis])
    }

    fn momentum_parts(&self) -> &'static [&'static str] {
        &["law/momentum/round", "law/clock/charged"]
    }

    fn swallows(&self, x: DVec3) -> bool {
        self.horizon().is_some_and(|horizon| x.distance(self.center) < horizon)
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let (r, horizon) = (at.distance(self.center), self.horizon()?);
        let problem = || format!("is inside the horizon: r = {r:.4} ≤ {horizon:.4}");
        (r <= horizon).then(|| [problem(), "move it away from the hole".to_owned()])
    }
}
