//! A Schwarzschild black hole (W04 §5.4), in path form or as the full geodesic.

use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::observer::{OBSERVER_PART, RoundHole};
use super::{CameraFrame, Invariant, Kind, Landmark, Law, Orbit, OrbitForm, Order};
use crate::document::keys;
use crate::document::values::{direction, positive, vector, word};
use crate::model::{Anchor, Binding, Capture, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "schwarzschild",
    keys: keys! {
        mass: "number above 0" = "1", "M, scene units (G = c = 1): the horizon is at r = 2M";
        center: "[x, y, z]" = "[0, 0, 0]", "the hole's place";
        form: "path | geodesic" = "path",
            "the equation that is integrated: of the path alone, or the full geodesic with its time";
        axis: "[x, y, z]" = "[0, 0, 1]", "what matter and observers on orbits go round, anticlockwise seen from its tip";
    },
    read: |table, _| {
        let forms = &[("path", SchwarzschildForm::Path), ("geodesic", SchwarzschildForm::Geodesic)];
        Some(Arc::new(Schwarzschild {
            mass: table.or("mass", 1.0, positive),
            center: table.or("center", DVec3::ZERO, vector),
            form: table.or("form", SchwarzschildForm::Path, word(forms)),
            axis: table.or("axis", DVec3::Z, direction),
        }))
    },
};

/// A black hole without spin or charge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schwarzschild {
    /// M, scene units (G = c = 1): the horizon is at r = 2M.
    pub mass: f64,
    /// The hole's place.
    pub center: DVec3,
    /// Which equation is integrated.
    pub form: SchwarzschildForm,
    /// The unit vector that matter and observers on orbits go round.
    pub axis: DVec3,
}

impl Schwarzschild {
    /// A hole in this place, of which paths are integrated.
    #[must_use]
    pub fn new(mass: f64, center: DVec3) -> Self {
        Self { mass, center, form: SchwarzschildForm::Path, axis: DVec3::Z }
    }

    fn round(&self, x: DVec3) -> RoundHole {
        let offset = x - self.center;
        let r = offset.length();
        let (clock, slope) = (1.0 - 2.0 * self.mass / r, 2.0 * self.mass / (r * r));
        RoundHole { offset, axis: self.axis, clock, slope, photon_sphere: 3.0 * self.mass }
    }
}

/// The two equations of light round the hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SchwarzschildForm {
    /// x″ = −3M h² x/r⁵, h = |x × v|: the geodesic with the null condition put in.
    Path,
    /// The geodesic equation as the 2004 paper integrates it, ṫ carried along.
    Geodesic,
}

impl Law for Schwarzschild {
    fn parts(&self) -> Vec<Wgsl> {
        match self.form {
            SchwarzschildForm::Path => {
                Wgsl::parts(&["law/accelerated", "law/start_as_given", "law/projected_as_is", "law/schwarzschild_path"])
            }
            SchwarzschildForm::Geodesic => Wgsl::parts(&["law/projected_as_is", "law/schwarzschild_geodesic"]),
        }
    }

    fn values(&self) -> Vec<Binding> {
        vec![Binding::one("law", row! { center: Vec3(self.center), mass: Float(self.mass) })]
    }

    fn order(&self) -> Order {
        match self.form {
            SchwarzschildForm::Path => Order::Place,
            SchwarzschildForm::Geodesic => Order::General,
        }
    }

    fn carries_time(&self) -> bool {
        self.form == SchwarzschildForm::Geodesic
    }

    /// At the horizon, or as far out as the photon sphere where nothing lies between that a ray moving inwards could still hit.
    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let is_clear = clearance.is_some_and(|clearance| clearance(self.center) > 3.0 * self.mass);
        let radius = if is_clear { 3.0 * self.mass } else { 2.0 * self.mass };
        vec![Capture { anchor: Anchor::center(self.center), radius }]
    }

    fn orbit(&self) -> Option<Orbit> {
        let orbit =
            Orbit { center: self.center, form: OrbitForm::Plane("law/orbit/schwarzschild"), is_free_far_away: true };
        (self.form == SchwarzschildForm::Path).then_some(orbit)
    }

    /// h = |x × v| and E² = ṙ² + (1 − 2M/r) h²/r², which together are the null condition.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let d = x - self.center;
        let (r, momentum) = (d.length(), d.cross(v).length());
        let energy = ((d.dot(v) / r).powi(2) + (1.0 - 2.0 * self.mass / r) * (momentum / r).powi(2)).sqrt();
        vec![
            Invariant { name: "angular momentum", value: momentum, size: r * v.length() },
            Invariant { name: "energy", value: energy, size: v.length() },
        ]
    }

    fn landmarks(&self) -> Vec<Landmark> {
        vec![Landmark::sphere("horizon", self.center, 2.0 * self.mass, true)]
    }

    fn frame_part(&self, frame: CameraFrame) -> Option<&'static str> {
        match frame {
            CameraFrame::Static => Some("camera/frame_static"),
            frame => RoundHole::knows(frame).then_some(OBSERVER_PART),
        }
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
        &["law/momentum/round", "law/clock/schwarzschild"]
    }

    fn swallows(&self, x: DVec3) -> bool {
        x.distance(self.center) < 2.0 * self.mass
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let (r, horizon) = (at.distance(self.center), 2.0 * self.mass);
        let problem = || format!("is inside the horizon: r = {r:.4} ≤ 2M = {horizon}");
        (r <= horizon).then(|| [problem(), "move it away from the hole".to_owned()])
    }

    fn refuses_surfaces(&self, interiors: bool) -> Option<&'static str> {
        let full = self.form == SchwarzschildForm::Geodesic && interiors;
        full.then_some("interiors go with the path form of the schwarzschild law")
    }
}
