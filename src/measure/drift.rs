//! What a law keeps along a ray: a check of accuracy that needs no truth.
//!
//! *Theory.* Force centres keep the energy ½|v|² + V, and a single one also the angular momentum x × v; a Schwarzschild hole keeps
//! h = |x × v| and E² = ṙ² + (1 − 2M/r) h²/r², which together are the null condition; a medium keeps |v| = n (noise
//! is known where it is 1, outside an explosion). Flows keep nothing. By how much the end of a ray departs from its start is the drift, relative to what the quantity is made of.

#![allow(clippy::many_single_char_names)] // the formulas' own letters

use glam::DVec3;

use super::Quantiles;
use crate::render::{Status, Traced};
use crate::scene::{Falloff, Law, Source};

/// A quantity's name, its value, and the size of what it is made of.
type Kept = (&'static str, f64, f64);

/// What the law keeps, at a point of a ray.
#[must_use]
pub fn kept(law: &Law, x: DVec3, v: DVec3) -> Vec<Kept> {
    match law {
        Law::Straight => vec![("speed", v.length(), v.length())],
        Law::Schwarzschild { mass, center, .. } => {
            let d = x - *center;
            let (r, h) = (d.length(), d.cross(v).length());
            let energy = ((d.dot(v) / r).powi(2) + (1.0 - 2.0 * mass / r) * (h / r).powi(2)).sqrt();
            vec![("angular momentum", h, r * v.length()), ("energy", energy, v.length())]
        }
        Law::Sources(sources) => {
            let kinetic = 0.5 * v.length_squared();
            let potential = sources.iter().map(|source| potential(source, x.distance(source.position)));
            let size = kinetic + potential.clone().map(f64::abs).sum::<f64>();
            let mut all = vec![("energy", kinetic + potential.sum::<f64>(), size)];
            if let [only] = sources.as_slice() {
                let d = x - only.position;
                all.push(("angular momentum", d.cross(v).length(), d.length() * v.length()));
            }
            all
        }
        Law::Medium(medium) => medium.index(x).map(|n| ("|v| / n", v.length() / n, 1.0)).into_iter().collect(),
        Law::Flow { .. } => Vec::new(),
    }
}

/// V at a distance from a source, 0 far away.
fn potential(source: &Source, r: f64) -> f64 {
    source.strength
        * match source.falloff {
            Falloff::InverseSquare => -1.0 / r,
            Falloff::Yukawa { mu } => -(-mu * r).exp() / r,
            Falloff::Cubic { radius } if r < radius => {
                r.powi(4) / (2.0 * radius.powi(3)) - r.powi(3) / radius.powi(2) + r - 0.5 * radius
            }
            Falloff::Cubic { .. } => 0.0,
        }
}

/// Each quantity's drift over rays that were followed to an end: from `starts` (x and v) to their ends.
#[must_use]
pub fn drift<'r>(law: &Law, rays: impl Iterator<Item = ([DVec3; 2], &'r Traced)>) -> Vec<(&'static str, Quantiles)> {
    let mut drifts: Vec<(&'static str, Vec<f64>)> = Vec::new();
    for ([x, v], end) in rays {
        if !matches!(end.status, Status::Hit | Status::Escaped | Status::Captured | Status::Ended) {
            continue;
        }
        let before = kept(law, x, v);
        let after = kept(law, end.x.into(), end.v.into());
        for (name, value, size) in &after {
            let Some((_, first, first_size)) = before.iter().find(|(other, ..)| other == name) else { continue };
            let drift = (value - first).abs() / size.max(*first_size);
            match drifts.iter_mut().find(|(other, _)| other == name) {
                Some((_, all)) => all.push(drift),
                None => drifts.push((name, vec![drift])),
            }
        }
    }
    drifts.into_iter().map(|(name, all)| (name, Quantiles::of(all))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Medium, SchwarzschildForm};

    /// Along a tiny step of the law's own motion, what it keeps changes by the square of the step.
    #[test]
    fn kept_quantities_are_kept() {
        let source = |position, strength, falloff| Source { position, strength, falloff, capture: 0.0 };
        let laws = [
            Law::Straight,
            Law::Schwarzschild { mass: 1.3, center: DVec3::X, form: SchwarzschildForm::Path },
            Law::Sources(vec![source(DVec3::Y, 2.0, Falloff::Yukawa { mu: 0.7 })]),
            Law::Sources(vec![
                source(DVec3::Y, -2.0, Falloff::InverseSquare),
                source(DVec3::Z, 1.5, Falloff::Cubic { radius: 9.0 }),
            ]),
            Law::Medium(Medium::Fisheye { center: DVec3::X, n0: 2.0, a: 4.0 }),
            Law::Medium(Medium::Sech { origin: DVec3::Y, up: DVec3::Z, n0: 1.5, g: 0.3 }),
        ];
        let x = DVec3::new(3.0, -2.0, 4.0);
        for law in &laws {
            let v = law.starting_velocity(x, DVec3::new(-0.5, 0.7, 0.4));
            let change = |h: f64| {
                let p = (x + h * v + 0.5 * h * h * acceleration(law, x, v), v + h * acceleration(law, x, v));
                let pairs = kept(law, x, v).into_iter().zip(kept(law, p.0, p.1));
                pairs.map(|(a, b)| (a.1 - b.1).abs()).fold(0.0, f64::max)
            };
            assert!(!kept(law, x, v).is_empty());
            let (large, small) = (change(1e-3), change(1e-4));
            assert!(large < 1e-5 && small <= 0.02 * large + 1e-14, "{law:?}: {large:e}, {small:e}");
        }
    }

    fn acceleration(law: &Law, x: DVec3, v: DVec3) -> DVec3 {
        match law {
            Law::Schwarzschild { mass, center, .. } => {
                let d = x - *center;
                -3.0 * mass * d.cross(v).length_squared() / d.length().powi(5) * d
            }
            Law::Sources(sources) => sources
                .iter()
                .map(|source| {
                    let d = x - source.position;
                    let r = d.length();
                    let strength = match source.falloff {
                        Falloff::InverseSquare => 1.0 / (r * r),
                        Falloff::Yukawa { mu } => (-mu * r).exp() * (1.0 + mu * r) / (r * r),
                        Falloff::Cubic { radius: f } => 2.0 * (r / f).powi(3) - 3.0 * (r / f).powi(2) + 1.0,
                    };
                    -source.strength * strength / r * d
                })
                .sum(),
            Law::Medium(medium) => {
                // The slope of n²/2; its own error, some 1e-10, is far under what is asked for.
                let half_square = |x: DVec3| 0.5 * medium.index(x).unwrap().powi(2);
                let slope = |axis: DVec3| (half_square(x + 1e-5 * axis) - half_square(x - 1e-5 * axis)) / 2e-5;
                DVec3::from_array(DVec3::AXES.map(slope))
            }
            _ => DVec3::ZERO,
        }
    }
}
