//! Non-rotating black holes, optionally with charge and a cosmological constant.
//!
//! *Theory.* ds² = −A dt² + dr²/A + r² dΩ² with A = 1 − 2M/r + Q²/r² − Λr²/3. Paths follow from the Binet equation u″ + u = 3Mu² − 2Q²u³. Λ
//! cancels there, and affects only the measurements of observers.

use glam::{DMat4, DVec3, DVec4};

use super::observer::{four_velocity, spherical};
use super::{CharacteristicSurface, Invariant, Law, LawProperties, OBSERVER_PART, Observer, Orbit, OrbitForm, Order};
use crate::model::halved::halved;
use crate::model::{Anchor, Binding, Capture, Value, Wgsl, row};

/// A non-rotating black hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundHole {
    /// The mass M, in scene units (G = c = 1), above 0.
    pub mass: f64,
    /// The charge Q, in scene units; 0 except in [`HoleForm::Charged`].
    pub charge: f64,
    /// The cosmological constant Λ; 0 except in [`HoleForm::Charged`].
    pub cosmological: f64,
    /// The position of the black hole.
    pub center: DVec3,
    /// The unit vector around which matter and observers orbit.
    pub axis: DVec3,
    /// The equation that is integrated.
    pub form: HoleForm,
}

/// The equations of light around the black hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HoleForm {
    /// The path equation x″ = −3M h² x/r⁵, h = |x × v|: the Schwarzschild geodesic with the null condition substituted.
    Path,
    /// The geodesic equation as Weiskopf et al. (2004) integrate it, including ṫ.
    Geodesic,
    /// The path equation with Q, and observers with Λ.
    Charged,
}

impl RoundHole {
    /// Creates a Schwarzschild black hole of the mass `mass`, above 0, at `center`, both in scene units (G = c = 1), with the path
    /// equation.
    ///
    /// # Examples
    ///
    /// ```
    /// use bentray::glam::DVec3;
    /// use bentray::model::law::RoundHole;
    ///
    /// let hole = RoundHole::new(2.0, DVec3::ZERO);
    /// assert_eq!((hole.horizon(), hole.photon_sphere()), (Some(4.0), Some(6.0)));
    /// ```
    #[must_use]
    pub fn new(mass: f64, center: DVec3) -> Self {
        Self { mass, charge: 0.0, cosmological: 0.0, center, axis: DVec3::Z, form: HoleForm::Path }
    }

    /// Returns A of the line element, which is −`g_tt`, at radius r.
    #[must_use]
    pub fn clock(&self, r: f64) -> f64 {
        1.0 - 2.0 * self.mass / r + (self.charge / r).powi(2) - self.cosmological * r * r / 3.0
    }

    /// Returns the radius of the photon sphere, below which rays that move inwards never return; `None` without a horizon.
    #[must_use]
    pub fn photon_sphere(&self) -> Option<f64> {
        let triple = 3.0 * self.mass;
        let root = (triple * triple - 8.0 * self.charge * self.charge).sqrt();
        (self.charge.abs() <= self.mass).then_some(0.5 * (triple + root))
    }

    /// Returns the smallest Λ for which A is positive nowhere.
    pub(super) fn cosmological_most(&self) -> f64 {
        let flat = Self { cosmological: 0.0, ..*self };
        self.photon_sphere().map_or(0.0, |r| 3.0 * flat.clock(r) / (r * r))
    }

    /// Returns the radius of the horizon, if there is one: the zero of A below the photon sphere, by bisection if Λ ≠ 0.
    #[must_use]
    pub fn horizon(&self) -> Option<f64> {
        let sphere = self.photon_sphere()?;
        if self.cosmological == 0.0 {
            return Some(self.mass + (self.mass * self.mass - self.charge * self.charge).sqrt());
        }
        // The minimum of A is below 0, at Q² = Mr; without charge there is no minimum.
        let low = (self.charge * self.charge / self.mass).max(1e-6 * self.mass);
        Some(halved(low, sphere, 100, |r| self.clock(r) > 0.0)[1])
    }

    /// Returns a capture sphere of this radius around the black hole.
    fn sphere(&self, radius: f64) -> Capture {
        Capture { anchor: Anchor::center(self.center), radius }
    }

    /// Returns dφ/dt of the circular orbit through a position in the plane perpendicular to the axis: Ω² = A′/2r.
    fn orbiting(&self, offset: DVec3) -> Option<f64> {
        let r = offset.length();
        let slope = 2.0 * (self.mass - self.charge * self.charge / r) / (r * r) - 2.0 * self.cosmological * r / 3.0;
        let turning = (0.5 * slope / r).sqrt();
        (offset.dot(self.axis).abs() <= 1e-9 * r && turning.is_finite()).then_some(turning)
    }

    /// Returns the four-velocity with E = 1 and L = 0.
    fn falling(&self, offset: DVec3) -> Option<DVec4> {
        let clock = self.clock(offset.length());
        let inwards = (1.0 - clock).sqrt();
        inwards.is_finite().then(|| (-inwards * offset.normalize()).extend(1.0 / clock))
    }
}

impl Law for RoundHole {
    fn parts(&self) -> Vec<Wgsl> {
        let path = |own| Wgsl::parts(&["law/accelerated", "law/start_as_given", "law/projected_as_is", own]);
        match self.form {
            HoleForm::Path => path("law/schwarzschild_path"),
            HoleForm::Geodesic => Wgsl::parts(&["law/projected_as_is", "law/schwarzschild_geodesic"]),
            HoleForm::Charged => path("law/charged_path"),
        }
    }

    fn values(&self) -> Vec<Binding> {
        let mut row = row! { center: Vec3(self.center), mass: Float(self.mass) };
        if self.form == HoleForm::Charged {
            row.push(("charge_squared".into(), Value::Float(self.charge * self.charge)));
            row.push(("third".into(), Value::Float(self.cosmological / 3.0)));
        }
        vec![Binding::one("law", row)]
    }

    fn facts(&self) -> LawProperties<'_> {
        let is_geodesic = self.form == HoleForm::Geodesic;
        let (pull, momentum_parts) = match self.form {
            HoleForm::Charged => {
                ("law/orbit/charged", &["law/momentum/radius", "law/momentum/round", "law/clock/charged"])
            }
            _ => ("law/orbit/schwarzschild", &["law/momentum/radius", "law/momentum/round", "law/clock/schwarzschild"]),
        };
        let orbit = Orbit { center: self.center, form: OrbitForm::Plane(pull), is_free_far_away: true };
        LawProperties {
            order: if is_geodesic { Order::General } else { Order::Place },
            carries_time: is_geodesic,
            orbit: (!is_geodesic).then_some(orbit),
            momentum_parts,
            flows: &[Observer::Zamo, Observer::ProgradeOrbit, Observer::RetrogradeOrbit, Observer::Infalling],
            swallows: self.horizon().map(|horizon| self.sphere(horizon)),
            refuses_interiors: is_geodesic.then_some("interiors require law.form = \"path\""),
            ..LawProperties::default()
        }
    }

    /// Captures at the horizon, or at the photon sphere if no object is between the two that a ray moving inwards could still hit.
    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let (Some(sphere), Some(horizon)) = (self.photon_sphere(), self.horizon()) else { return Vec::new() };
        let is_clear = clearance.is_some_and(|clearance| clearance(self.center) > sphere);
        vec![self.sphere(if is_clear { sphere } else { horizon })]
    }

    /// Returns h = |x × v| and E² = ṙ² + (1 − 2M/r + Q²/r²) h²/r². Together they are the null condition, because Λ only adds a function of
    /// h.
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

    fn landmarks(&self) -> Vec<CharacteristicSurface> {
        let horizon = |radius| CharacteristicSurface::sphere("horizon", self.center, radius, true);
        self.horizon().map(horizon).into_iter().collect()
    }

    fn remark(&self, _: DVec3, _: f64) -> Option<String> {
        let remark = || {
            "the black hole has no horizon, because Q is above M: the singularity is naked, and repels light".to_owned()
        };
        self.horizon().is_none().then(remark)
    }

    fn frame_part(&self, frame: Observer) -> Option<&'static str> {
        match (frame, self.form) {
            (Observer::Coordinate, _) => None,
            (Observer::Static, HoleForm::Path | HoleForm::Geodesic) => Some("camera/frame_static"),
            _ => Some(OBSERVER_PART),
        }
    }

    fn metric(&self, x: DVec3, _: f64) -> Option<DMat4> {
        let offset = x - self.center;
        let clock = self.clock(offset.length());
        Some(spherical(offset.normalize(), 1.0 / clock, 1.0, clock))
    }

    fn length_scale(&self, x: DVec3) -> f64 {
        x.distance(self.center)
    }

    /// Without spin a static observer has no angular momentum, and is also an Eulerian observer.
    fn observer(&self, frame: Observer, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        let offset = at - self.center;
        let found = match frame {
            Observer::Coordinate => return None,
            Observer::Infalling => self.falling(offset),
            _ => {
                let as_static = matches!(frame, Observer::Eulerian | Observer::Zamo);
                let frame = if as_static { Observer::Static } else { frame };
                let orbiting = |sense: f64| Some(sense * self.orbiting(offset)?);
                four_velocity(&self.metric(at, 0.0)?, frame, self.axis.cross(offset), &orbiting)
            }
        };
        Some(found.ok_or_else(|| match frame {
            Observer::ProgradeOrbit | Observer::RetrogradeOrbit => {
                let beyond = self.photon_sphere().unwrap_or(0.0);
                let help = format!(
                    "circular orbits are in the plane through the black hole perpendicular to \
                     law.axis, beyond r = {beyond:.4}"
                );
                ["is not on a circular orbit".to_owned(), help]
            }
            Observer::Infalling => {
                let help = "charge or Λ turns infalling observers back before this position; use observer = \
                            \"boosted\" and camera.velocity";
                ["is where no observer can have fallen from rest", help].map(str::to_owned)
            }
            _ => ["is where nothing can be static", "move it"].map(str::to_owned),
        }))
    }

    fn equator(&self) -> Option<[DVec3; 2]> {
        Some([self.center, self.axis])
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let (r, horizon) = (at.distance(self.center), self.horizon()?);
        let horizon_words = || match self.form {
            HoleForm::Charged => format!("{horizon:.4}"),
            _ => format!("2M = {horizon}"),
        };
        let problem = || format!("is inside the horizon: r = {r:.4} ≤ {}", horizon_words());
        (r <= horizon).then(|| [problem(), "move it away from the black hole".to_owned()])
    }
}
