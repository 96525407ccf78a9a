//! A rotating charged black hole (Kerr–Newman) in Cartesian ingoing Kerr–Schild coordinates.
//!
//! *Theory.* g = η + f l l with a null vector l and f = (2Mr − Q²)/(r² + a² cos²θ). The congruence of l is shear-free, so that ∂ᵢlⱼ follows
//! from two scalars at each position, its expansion and its twist, and the geodesic equation in the shader takes few vector operations.
//! Rays go into the past by τ = `t_camera` − t, and v = dx/dτ.
//!
//! *Practice.* The state is position and velocity, as under the other laws, instead of position and momentum: also six numbers, and arcs,
//! surfaces and traces need v. The null condition is therefore not built in, but conserved, and measures the accuracy of a path.
//!
//! *Length.* This file is over 300 lines, because no other code needs the host's description of this spacetime (horizons, frames, the edge
//! of its shadow).

use std::cmp::Ordering;
use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::observer::{four_velocity, light_speed};
use super::{CharacteristicSurface, Invariant, Kind, Law, LawProperties, Observer, Orbit, OrbitForm, Order, Spherical};
use crate::document::keys;
use crate::document::values::{direction, length, mass, point};
use crate::model::halved::halved;
use crate::model::point_source::spheroid;
use crate::model::{Anchor, Binding, Capture, Wgsl, row};

/// The distance, as a fraction of M, to which rays approach a horizon that they would reach after infinite time, or the ring of a naked
/// singularity.
const NEAR: f64 = 0.01;

pub static KIND: Kind = Kind {
    name: "kerr-newman",
    keys: keys! {
        mass: "number above 0" = "1", "M, scene units (G = c = 1)";
        spin: "number" = "0", "spin parameter a, the angular momentum over M, in scene units; |a| up to M has a horizon; negative values reverse the rotation";
        charge: "number" = "0", "Q, in scene units; a² + Q² up to M² has a horizon";
        axis: "[x, y, z]" = "[0, 0, 1]", "spin axis, counterclockwise seen from its tip";
        center: "[x, y, z]" = "[0, 0, 0]", "position of the black hole";
    },
    read: |table, _| {
        let spin = table.or("spin", 0.0, length);
        Some(Arc::new(KerrNewman {
            mass: table.or("mass", 1.0, mass),
            spin: spin.abs(),
            axis: table.or("axis", DVec3::Z, direction) * if spin < 0.0 { -1.0 } else { 1.0 },
            charge: table.or("charge", 0.0, length),
            center: table.or("center", DVec3::ZERO, point),
        }))
    },
};

/// A rotating charged black hole or, if a² + Q² exceeds M², a naked ring singularity.
///
/// # Examples
///
/// ```
/// use bentray::glam::DVec3;
/// use bentray::model::law::KerrNewman;
///
/// let hole = KerrNewman { mass: 1.0, spin: 0.6, axis: DVec3::Z, charge: 0.0, center: DVec3::ZERO };
/// assert!((hole.horizon().unwrap_or_default() - 1.8).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KerrNewman {
    /// The mass M, in scene units (G = c = 1), above 0.
    pub mass: f64,
    /// The spin a, in scene units, at least 0.
    pub spin: f64,
    /// The unit vector of the spin axis; the rotation is counterclockwise seen from its tip.
    pub axis: DVec3,
    /// The charge Q, in scene units.
    pub charge: f64,
    /// The position of the black hole.
    pub center: DVec3,
}

/// The metric at a position: g = η + f l l, `l_t` = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KerrSchild {
    /// The Boyer–Lindquist radius r.
    pub r: f64,
    /// The unit vector l.
    pub l: DVec3,
    /// The deviation f from flat spacetime; 1 on the edge of the ergosphere.
    pub f: f64,
}

impl KerrNewman {
    /// Returns the components of the metric at x.
    #[must_use]
    pub fn at(&self, x: DVec3) -> KerrSchild {
        let (d, a) = (x - self.center, self.spin * self.axis);
        let (r, outwards) = spheroid::of(d, a);
        let sigma = r * r + (a.dot(d) / r).powi(2);
        KerrSchild {
            r,
            l: (outwards + d.cross(a)) / (r * r + a.length_squared()),
            f: (2.0 * self.mass * r - self.charge * self.charge) / sigma,
        }
    }

    /// Returns r of the outer horizon, if there is one.
    #[must_use]
    pub fn horizon(&self) -> Option<f64> {
        let left = self.mass * self.mass - self.spin * self.spin - self.charge * self.charge;
        (left >= 0.0).then(|| self.mass + left.sqrt())
    }

    /// Returns r of the inner horizon, below which infall has no unique continuation; 0 without spin and charge.
    #[must_use]
    pub fn inner_horizon(&self) -> Option<f64> {
        Some((self.spin * self.spin + self.charge * self.charge) / self.horizon()?)
    }

    /// Returns the capture surface of constant r.
    fn spheroid(&self, radius: f64) -> Capture {
        Capture {
            anchor: Anchor { kind: &spheroid::KIND, position: self.center, along: self.spin * self.axis },
            radius,
        }
    }

    /// Returns r of the prograde circular photon orbit; rays that move inwards below it never return.
    #[must_use]
    pub fn photon_orbit(&self) -> Option<f64> {
        self.circular_light(1.0)
    }

    /// Returns the integral of dr/Δ from infinity to r.
    fn wound(&self, r: f64) -> f64 {
        let from = r - self.mass;
        let square = self.mass * self.mass - self.spin * self.spin - self.charge * self.charge;
        let half = square.abs().sqrt();
        match square.partial_cmp(&0.0) {
            Some(Ordering::Greater) => ((from - half).abs() / (from + half)).ln() / (2.0 * half),
            Some(Ordering::Less) => -half.atan2(from) / half,
            _ => -1.0 / from,
        }
    }

    /// Returns `true` if photon orbits extend into the capture region.
    fn is_extreme(&self) -> bool {
        let inner = self.horizon().zip(self.photon_orbit());
        inner.is_some_and(|(horizon, orbit)| orbit < horizon + NEAR * self.mass)
    }

    /// Returns r of the circular photon orbit that is prograde (`sense` = 1) or retrograde (−1).
    fn circular_light(&self, sense: f64) -> Option<f64> {
        let (m, q2, a) = (self.mass, self.charge * self.charge, sense * self.spin);
        let beyond = |r: f64| r * r - 3.0 * m * r + 2.0 * q2 + 2.0 * a * (m * r - q2).max(0.0).sqrt();
        Some(halved(self.horizon()?, 4.0 * m, 100, |r| beyond(r) > 0.0)[0])
    }

    /// Returns dφ/dt of the prograde or retrograde circular orbit through a position on the equator; `None` elsewhere.
    fn orbiting(&self, at: DVec3, sense: f64) -> Option<f64> {
        let (d, r) = (at - self.center, self.at(at).r);
        let speed = (self.mass * r - self.charge * self.charge).sqrt();
        let is_equatorial = d.dot(self.axis).abs() <= 1e-6 * r;
        (is_equatorial && speed > 0.0).then(|| sense * speed / (r * r + sense * self.spin * speed))
    }

    /// Returns the four-velocity of free fall from rest at infinity without angular momentum, or `None` where the charge repels it.
    fn falling(&self, at: DVec3) -> Option<DVec4> {
        let (KerrSchild { r, l, .. }, d, a) = (self.at(at), at - self.center, self.spin);
        let cos2 = (d.dot(self.axis) / r).powi(2);
        let (s, n) = (r * r + a * a, 2.0 * self.mass * r - self.charge * self.charge);
        let sigma = r * r + a * a * cos2;
        let (root, pull) = (s.sqrt(), n.sqrt());
        let inwards = root * pull;
        let turning = a * pull / (root + pull);
        let time = root * (s + inwards + n) / (root + pull) - a * a * (1.0 - cos2);
        let velocity = -inwards * l - turning * self.axis.cross(d);
        (n >= 0.0).then(|| velocity.extend(time) / sigma)
    }

    fn says_static(&self) -> [String; 2] {
        let edge = self.mass + (self.mass * self.mass - self.charge * self.charge).max(0.0).sqrt();
        let problem = "is inside the ergosphere, where nothing can be static".to_owned();
        [problem, format!("use observer = \"zamo\", or move it: the ergosphere ends at r = {edge:.4}")]
    }

    fn says_orbiting(&self, sense: f64) -> [String; 2] {
        let orbit = self.circular_light(sense).map_or(String::new(), |r| format!(", beyond r = {r:.4}"));
        let problem = "is not on a circular orbit".to_owned();
        [problem, format!("circular orbits are in the plane through the black hole perpendicular to its axis{orbit}")]
    }
}

impl Law for KerrNewman {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["law/by_velocity", "law/projected_as_is", "law/spheroid", "law/light_speed", "law/kerr_newman"])
    }

    fn values(&self) -> Vec<Binding> {
        let row = row! {
            center: Vec3(self.center),
            mass: Float(self.mass),
            spin: Vec3(self.spin * self.axis),
            axis: Vec3(self.axis),
            charge_squared: Float(self.charge * self.charge),
        };
        vec![Binding::one("law", row)]
    }

    /// The orbit equation needs a horizon: without one, rays reach r = 0, where u diverges.
    fn facts(&self) -> LawProperties<'_> {
        let orbit = Orbit { center: self.center, form: OrbitForm::Separated, is_free_far_away: true };
        LawProperties {
            order: Order::General,
            keeps_time: true,
            orbit: self.horizon().map(|_| orbit),
            turns_before_capture: self.is_extreme(),
            momentum_parts: &["law/momentum/kerr_newman"],
            flows: &[Observer::Zamo, Observer::ProgradeOrbit, Observer::RetrogradeOrbit, Observer::Infalling],
            below: self.horizon().map(|horizon| ("law/below_kerr_newman", self.spheroid(horizon))),
            swallows: self.inner_horizon().map(|inner| self.spheroid(inner)),
            refuses_interiors: Some(
                "under the law of a rotating black hole, the speed of light in an interior is not defined",
            ),
            refuses_sent_light: Some(
                "near a rotating black hole, light does not retrace the path of a ray from the camera",
            ),
            ..LawProperties::default()
        }
    }

    /// Captures at the innermost photon orbit, or just outside the horizon if an object is further in.
    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let near = NEAR * self.mass;
        let radius = match (self.horizon(), self.photon_orbit()) {
            (Some(horizon), Some(orbit)) => {
                let outermost = orbit.hypot(self.spin);
                let is_clear = clearance.is_some_and(|clearance| clearance(self.center) > outermost);
                if is_clear { orbit.max(horizon + near) } else { horizon + near }
            }
            _ => near,
        };
        vec![self.spheroid(radius)]
    }

    /// Returns the null condition, L/E along the axis, and the Carter constant divided by E², which is regular on the axis. All except the
    /// first require rays that reach infinity, whose energy E is positive.
    #[allow(clippy::many_single_char_names)] // the formulas' own letters
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let KerrSchild { r, l, f } = self.at(x);
        let d = x - self.center;
        let w = 1.0 - l.dot(v);
        let null = Invariant { name: "null condition", value: v.length_squared() + f * w * w, size: 1.0 };
        let energy = 1.0 - f * w;
        if energy <= 0.0 {
            return vec![null];
        }
        let p = (v - f * w * l) / energy;
        let axis = self.axis;
        let (height, lift) = (d.dot(axis), p.dot(axis));
        let (aside, along) = (d - height * axis, p - lift * axis);
        let (a2, cos2) = (self.spin * self.spin, (height / r).powi(2));
        let carter = cos2 * ((r * r + a2) * along.length_squared() - a2) - 2.0 * height * aside.dot(along) * lift
            + r * r * (1.0 - cos2) * lift * lift;
        let momentum = -axis.dot(d.cross(p));
        let size = d.length() * p.length();
        vec![
            null,
            Invariant { name: "L / E", value: momentum, size },
            Invariant { name: "Carter's Q / E²", value: carter, size: size * size },
        ]
    }

    /// Returns the horizon and the ergosphere r = M + √(M² − Q² − a² cos²θ), inside which nothing can be static.
    fn landmarks(&self) -> Vec<CharacteristicSurface> {
        let Some(horizon) = self.horizon() else { return Vec::new() };
        if self.spin == 0.0 {
            return vec![CharacteristicSurface::sphere("horizon", self.center, horizon, true)];
        }
        let Self { mass, spin, axis, charge, center } = *self;
        let within = move |x: DVec3, edge: &dyn Fn(f64) -> f64| {
            let d = x - center;
            let r = spheroid::of(d, spin * axis).0;
            r < horizon || r < edge((axis.dot(d) / r).powi(2))
        };
        let left = mass * mass - charge * charge;
        let ergosphere = move |cos2: f64| mass + (left - spin * spin * cos2).max(0.0).sqrt();
        let landmark = |name, r: f64, captures, inside| CharacteristicSurface {
            name,
            center,
            radius: r.hypot(spin),
            captures,
            inside: Some(inside),
        };
        vec![
            landmark("ergosphere", ergosphere(0.0), false, Arc::new(move |x| within(x, &ergosphere))),
            landmark("horizon", horizon, true, Arc::new(move |x| within(x, &|_| horizon))),
        ]
    }

    fn remark(&self, _: DVec3, _: f64) -> Option<String> {
        let remark =
            || "the black hole has no horizon, because a² + Q² is above M²: the ring singularity is naked".to_owned();
        self.horizon().is_none().then(remark)
    }

    /// Returns a velocity along v at the speed of light.
    fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        let KerrSchild { l, f, .. } = self.at(x);
        let along = l.dot(v);
        v / light_speed(1.0 - f, f * along, f * along * along + v.length_squared())
    }

    fn metric(&self, x: DVec3, _: f64) -> Option<DMat4> {
        let KerrSchild { l, f, .. } = self.at(x);
        let l = l.extend(1.0);
        let flat = DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, -1.0));
        Some(flat + f * DMat4::from_cols(l.x * l, l.y * l, l.z * l, l.w * l))
    }

    fn length_scale(&self, x: DVec3) -> f64 {
        self.at(x).r
    }

    fn observer(&self, frame: Observer, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        let found = match frame {
            Observer::Coordinate => return None,
            Observer::Infalling => self.falling(at),
            _ => {
                let around = self.axis.cross(at - self.center);
                four_velocity(&self.metric(at, 0.0)?, frame, around, &|sense| self.orbiting(at, sense))
            }
        };
        Some(found.ok_or_else(|| match frame {
            Observer::Static => self.says_static(),
            Observer::ProgradeOrbit => self.says_orbiting(1.0),
            Observer::RetrogradeOrbit => self.says_orbiting(-1.0),
            _ => ["is where this observer cannot exist", "move it away from the black hole"].map(str::to_owned),
        }))
    }

    fn equator(&self) -> Option<[DVec3; 2]> {
        Some([self.center, self.axis])
    }

    /// Returns Boyer–Lindquist coordinates: with Δ = r² − 2Mr + a² + Q², ingoing Kerr–Schild coordinates have dφ + a dr/Δ and
    /// dt + (2Mr − Q²) dr/Δ instead of dφ and dt, and x + iy = (r + ia) sin θ e^(iφ).
    fn spherical(&self, x: DVec3) -> Option<Spherical> {
        let Self { mass, spin, charge, .. } = *self;
        let r = self.at(x).r;
        let delta = r * r - 2.0 * mass * r + spin * spin + charge * charge;
        let wound = self.wound(r);
        let azimuth = Spherical::about(self.axis, x - self.center).azimuth - spin.atan2(r) - spin * wound;
        let time_ahead = mass * (delta.abs() / (mass * mass)).ln() + (2.0 * mass * mass - charge * charge) * wound;
        Some(Spherical { radius: r, azimuth: azimuth.sin().atan2(azimuth.cos()), time_ahead })
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let (r, inner) = (self.at(at).r, self.inner_horizon()?.max(NEAR * self.mass));
        let problem = || format!("is inside the inner horizon: r = {r:.4} ≤ {inner:.4}");
        (r <= inner).then(|| [problem(), "move it away from the black hole".to_owned()])
    }
}
