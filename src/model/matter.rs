//! Matter in a thin accretion disk around a black hole: its motion and its brightness.
//!
//! *Theory.* Outside the ISCO matter is on circular orbits; inside, it falls with the energy E and the angular momentum L of the ISCO. Each
//! face radiates the flux that viscosity releases between orbits (Page and Thorne 1974, eq. 15d), F = −Ω′/(4π √−g (E − ΩL)²) ∫ (E − ΩL) L′
//! dρ, integrated from the ISCO outwards and for Ṁ = 1.
//!
//! *Practice.* A law provides its metric and the four-velocities of circular orbits. Everything else follows numerically, so that every
//! axisymmetric spacetime supports disks. Derivatives are four-point differences; the relative error of F is about 1e-7.

use glam::{DMat3, DVec3, DVec4};

use super::halved::halved;
use super::law::{Law, Observer};

/// The state of matter at a distance ρ from the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// The distance ρ from the axis, in the scene's coordinates.
    pub rho: f64,
    /// The four-velocity: radial, azimuthal and time components.
    pub u: DVec3,
    /// The energy E.
    pub energy: f64,
    /// The angular momentum L.
    pub momentum: f64,
    /// The flux F of one face.
    pub flux: f64,
}

impl Orbit {
    /// Returns the angular velocity Ω = dφ/dt.
    #[must_use]
    pub fn turning(&self) -> f64 {
        self.u.y / (self.u.z * self.rho)
    }

    /// Returns E − ΩL.
    fn excess(&self) -> f64 {
        self.energy - self.turning() * self.momentum
    }
}

/// The equatorial plane of a law, with a radial direction in it.
struct Plane<'a> {
    law: &'a dyn Law,
    center: DVec3,
    out: DVec3,
    around: DVec3,
    sense: Observer,
}

impl<'a> Plane<'a> {
    fn of(law: &'a dyn Law, sense: Observer) -> Option<Self> {
        let [center, axis] = law.equator()?;
        let out = axis.any_orthonormal_vector();
        Some(Self { law, center, out, around: axis.cross(out), sense })
    }

    fn at(&self, rho: f64) -> DVec3 {
        self.center + rho * self.out
    }

    /// Returns the components of g in the radial, azimuthal and time directions.
    fn metric(&self, rho: f64) -> Option<DMat3> {
        let g = self.law.metric(self.at(rho), 0.0)?;
        let ways = [self.out.extend(0.0), self.around.extend(0.0), DVec4::W];
        Some(DMat3::from_cols_array_2d(&ways.map(|a| ways.map(|b| a.dot(g * b)))))
    }

    /// Returns the circular orbit at ρ, without its flux.
    fn circular(&self, rho: f64) -> Option<Orbit> {
        let u = self.law.observer(self.sense, self.at(rho))?.ok()?;
        let g = self.law.metric(self.at(rho), 0.0)?;
        let lowered = g * u;
        let momentum = rho * lowered.dot(self.around.extend(0.0));
        let u = DVec3::new(u.dot(self.out.extend(0.0)), u.dot(self.around.extend(0.0)), u.w);
        Some(Orbit { rho, u, energy: -lowered.w, momentum, flux: 0.0 })
    }

    /// Returns the derivative of a property of circular orbits by ρ.
    fn slope(&self, rho: f64, of: fn(&Orbit) -> f64) -> Option<f64> {
        let h = 1e-3 * rho;
        let change = |h: f64| Some((of(&self.circular(rho + h)?) - of(&self.circular(rho - h)?)) / (2.0 * h));
        Some((4.0 * change(0.5 * h)? - change(h)?) / 3.0)
    }

    /// Finds the minimum of L, inside of which no orbit is stable, by bisection from outside inwards.
    fn innermost_stable(&self, outer: f64) -> Option<f64> {
        let falls =
            |rho: f64| self.slope(rho, |orbit| orbit.momentum.abs()).is_none_or(|slope| slope.is_nan() || slope <= 0.0);
        let (mut below, mut above) = (outer, outer);
        while !falls(below) {
            above = below;
            below *= 0.97;
            if below < 1e-6 * outer {
                return None;
            }
        }
        if above >= outer {
            return None;
        }
        Some(halved(below, above, 60, |rho| !falls(rho))[1])
    }

    /// Returns matter that falls inwards with E and L, with u from its covector.
    fn falling(&self, rho: f64, edge: &Orbit) -> Option<Orbit> {
        let raise = self.metric(rho)?.inverse();
        // The radial component follows from u·u = −1 alone.
        let known = DVec3::new(0.0, edge.momentum / rho, -edge.energy);
        let (a, b, c) = (raise.x_axis.x, (raise * known).x, known.dot(raise * known) + 1.0);
        let root = (b * b - a * c).max(0.0).sqrt();
        let inwards = |part: f64| {
            let u = raise * (known + part * DVec3::X);
            (u.x <= 0.0 && u.z > 0.0 && u.is_finite()).then_some(u)
        };
        let u = inwards((-b - root) / a).or_else(|| inwards((-b + root) / a))?;
        Some(Orbit { rho, u, ..*edge })
    }
}

/// Returns ρ of the ISCO, if there is one within `outer`.
#[must_use]
pub fn innermost_stable(law: &dyn Law, outer: f64) -> Option<f64> {
    Plane::of(law, Observer::ProgradeOrbit)?.innermost_stable(outer)
}

/// Returns the ISCO of orbits in a sense, prograde or retrograde, if there is one within `outer`.
#[must_use]
pub fn last_stable(law: &dyn Law, outer: f64, sense: Observer) -> Option<Orbit> {
    let plane = Plane::of(law, sense)?;
    plane.circular(plane.innermost_stable(outer)?)
}

/// Returns `count` orbits in the equatorial plane of a law, with the index of the ISCO among them, or `None` if the law has no such orbits.
/// They are spaced evenly in ln ρ, from about a quarter of the ISCO's ρ to `outer`.
#[must_use]
pub fn orbits(law: &dyn Law, outer: f64, count: usize) -> Option<(usize, Vec<Orbit>)> {
    let plane = Plane::of(law, Observer::ProgradeOrbit)?;
    let edge = plane.circular(plane.innermost_stable(outer)?)?;
    let (within, beyond) = (4.0_f64.ln(), (outer / edge.rho).ln());
    let at_edge = ((count - 1) as f64 * within / (within + beyond)) as usize;
    let h = beyond / (count - 1 - at_edge) as f64;
    let falling = |i: usize| {
        let rho = edge.rho * (h * (i as f64 - at_edge as f64)).exp();
        // Inside a horizon some coordinates have no infalling orbit, and no observer outside sees it.
        plane.falling(rho, &edge).unwrap_or(Orbit { rho, ..edge })
    };
    let outside = shining(&plane, edge.rho, h, count - at_edge)?;
    Some((at_edge, (0..at_edge).map(falling).chain(outside).collect()))
}

/// Returns `count` circular orbits with their flux: the first is at the ISCO, and ρ grows by a factor eʰ from each to the next.
fn shining(plane: &Plane, edge: f64, h: f64, count: usize) -> Option<Vec<Orbit>> {
    // Derivatives and sums need two more orbits on both sides.
    let circles: Option<Vec<Orbit>> =
        (0..count + 4).map(|i| plane.circular(edge * (h * (i as f64 - 2.0)).exp())).collect();
    let circles = circles?;
    // The derivative by ln ρ.
    let slope = |k: usize, of: fn(&Orbit) -> f64| {
        let apart = |by: usize| of(&circles[k + 2 + by]) - of(&circles[k + 2 - by]);
        (8.0 * apart(1) - apart(2)) / (12.0 * h)
    };
    // L has its minimum at the edge, so that its derivative there is 0 up to rounding.
    let gain: Vec<f64> = (0..count).map(|k| circles[k + 2].excess() * slope(k, |orbit| orbit.momentum)).collect();
    let mut sum = 0.0;
    let mut rows = Vec::with_capacity(count);
    for k in 0..count {
        if k > 0 {
            // Integrates the cubic through four points, with linear extrapolation beyond the last and odd symmetry before the first.
            let after = gain.get(k + 1).copied().unwrap_or(2.0 * gain[k] - gain[k - 1]);
            let before = if k > 1 { gain[k - 2] } else { -gain[1] };
            sum += h / 24.0 * (13.0 * (gain[k - 1] + gain[k]) - before - after);
        }
        let orbit = circles[k + 2];
        let turned = slope(k, Orbit::turning) / orbit.rho;
        // ∂φ is ρ times the azimuthal unit vector.
        let volume = orbit.rho * (-plane.metric(orbit.rho)?.determinant()).sqrt();
        let flux = -turned * sum / (4.0 * std::f64::consts::PI * volume * orbit.excess().powi(2));
        rows.push(Orbit { flux, ..orbit });
    }
    Some(rows)
}
