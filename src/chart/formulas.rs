//! Formulas of transparent materials from T as charts: the Fresnel equations (Fig. 4), the Beer–Lambert law (Fig. 9), Snell's law, and the
//! spirals in an inverse-r sphere (Figs. 38 to 40).
//!
//! *Practice.* The host evaluates the closed forms in 64 bits; shaders have separate implementations, which tests compare with others.
//! Angles are in degrees, and η = `n_t/n_i` is the ratio of the transmitted to the incident index.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::DVec3;

use crate::measure::Curve;
use crate::model::shape::Sphere;
use crate::output::plot::{Chart, CrossSection, PathLine, PathPlot, PlotRange, Series, SurfaceKind};
use crate::render::PathPoint;
use crate::scene::{CutPlane, Object, Substance, Transform};

/// The number of samples of a curve over a right angle.
const SAMPLES: u32 = 360;
/// The angle in radians beyond which angles are not charted, because they diverge at the ends of their range.
const STEEPEST: f64 = 10.0;
/// The number of segments of a spiral per turn, whose cubic arcs have an error of 10⁻⁵ of their radius.
const SEGMENTS: f64 = 24.0;
/// The radius, relative to the sphere's, at which an inward spiral ends.
const INNERMOST: f64 = 0.005;

/// Returns the sine of the angle of refraction, if there is one: sin θₜ = sin θᵢ/η.
#[must_use]
pub fn refracted_sine(degrees: f64, eta: f64) -> Option<f64> {
    let sine = degrees.to_radians().sin() / eta;
    (sine <= 1.0).then_some(sine)
}

/// Returns the Fresnel reflectance `k_r` of unpolarized light (T Eqs. 4 to 6); the transmittance is 1 − `k_r` (T Eq. 7).
#[must_use]
pub fn reflectance(degrees: f64, eta: f64) -> f64 {
    let Some(sine) = refracted_sine(degrees, eta) else { return 1.0 };
    let (incident, refracted) = (degrees.to_radians().cos(), (1.0 - sine * sine).sqrt());
    let parallel = (eta * incident - refracted) / (eta * incident + refracted);
    let perpendicular = (incident - eta * refracted) / (incident + eta * refracted);
    0.5 * (parallel * parallel + perpendicular * perpendicular)
}

/// Returns `k_r` and `k_t` against the angle of incidence, for each η (T Fig. 4).
#[must_use]
pub fn fresnel_chart(etas: &[f64]) -> Chart {
    let series = |&eta: &f64| {
        let curve = |name: &str, value: &dyn Fn(f64) -> f64| Series {
            name: format!("{name}, η = {eta}"),
            points: angles(eta).into_iter().map(|degrees| [degrees, value(degrees)]).collect(),
        };
        [
            curve("reflected", &|degrees| reflectance(degrees, eta)),
            curve("transmitted", &|degrees| 1.0 - reflectance(degrees, eta)),
        ]
    };
    Chart::linear(
        "Fresnel reflectance and transmittance",
        ["angle of incidence (degrees)", "fraction of light"],
        etas.iter().flat_map(series).collect(),
    )
}

/// Returns the angle of refraction against the angle of incidence, for each η.
#[must_use]
pub fn snell_chart(etas: &[f64]) -> Chart {
    let point = |degrees: f64, eta: f64| refracted_sine(degrees, eta).map(|sine| [degrees, sine.asin().to_degrees()]);
    let series = |&eta: &f64| Series {
        name: format!("η = {eta}"),
        points: angles(eta).into_iter().filter_map(|degrees| point(degrees, eta)).collect(),
    };
    Chart::linear(
        "Snell's law (each curve ends where total reflection begins)",
        ["angle of incidence (degrees)", "angle of refraction (degrees)"],
        etas.iter().map(series).collect(),
    )
}

/// Returns degrees from 0 to 90, including the critical angle, where curves have a corner, if there is one.
fn angles(eta: f64) -> Vec<f64> {
    let mut angles: Vec<f64> = (0..=SAMPLES).map(|i| 90.0 * f64::from(i) / f64::from(SAMPLES)).collect();
    if eta < 1.0 {
        // The largest number of degrees whose sine is at most η.
        let critical = eta.asin().to_degrees();
        angles.push(if refracted_sine(critical, eta).is_some() { critical } else { critical.next_down() });
        angles.sort_by(f64::total_cmp);
    }
    angles
}

/// Returns the Beer–Lambert law: the transmittance cᵈ over a distance d, for each color component c (T Fig. 9).
#[must_use]
pub fn beer_chart(absorptions: &[f64], farthest: f64) -> Chart {
    let series = |&c: &f64| {
        let distances = (0..=SAMPLES).map(|i| farthest * f64::from(i) / f64::from(SAMPLES));
        Series::new(format!("c = {c}"), distances.map(|d| [d, c.powf(d)]).collect())
    };
    Chart::linear(
        "Beer-Lambert law",
        ["distance d in the medium", "fraction of light, c to the power d"],
        absorptions.iter().map(series).collect(),
    )
}

/// Returns the angle ln(R/S) cot ψ in radians around the center of an inverse-r sphere at which a ray leaves it, if it starts at the radius
/// S at the angle ψ (degrees) to the circle there (T Eq. 21).
#[must_use]
pub fn spiral_angle(ratio: f64, psi: f64) -> f64 {
    ratio.ln() / psi.to_radians().tan()
}

/// Returns this angle against ψ (T Fig. 39): in the quadrants III and IV the formula is valid, but the ray spirals into the center.
#[must_use]
pub fn spiral_chart(ratio: f64) -> Chart {
    let branch = |name: &str, from: f64| {
        let angles = (1..4 * SAMPLES).map(|i| from + 180.0 * f64::from(i) / f64::from(4 * SAMPLES));
        let points = angles.map(|psi| [psi, spiral_angle(ratio, psi)]).filter(|point| point[1].abs() <= STEEPEST);
        Series { name: name.to_owned(), points: points.collect() }
    };
    Chart::linear(
        format!("Rays in an inverse-r sphere: from S to R = {ratio:.4} S"),
        ["starting angle to the circle (degrees)", "swept angle (radians)"],
        vec![branch("I and II: outwards", 0.0), branch("III and IV: inwards", 180.0)],
    )
}

/// Returns rays from [S, 0] in a sphere of radius R = 1, at angles ψ (degrees) to the circle there (T Figs. 38 and 40): outwards to R,
/// inwards to near the center, and once around on the circle.
#[must_use]
pub fn spiral_plot<'n>(ratio: f64, psis: &[f64], names: &'n [String]) -> PathPlot<'n> {
    let plane = CutPlane { point: DVec3::ZERO, right: DVec3::X, up: DVec3::Y };
    let line = |(psi, name): (&f64, &'n String)| PathLine { curve: spiral(ratio, *psi), status: name };
    let place = Transform::new(DVec3::ONE, DVec3::ZERO, DVec3::ZERO);
    let sphere = Object::new(Arc::new(Sphere), place, Substance::Opaque(0));
    let surfaces = vec![CrossSection { kind: SurfaceKind::Medium, outlines: sphere.cut(&plane) }];
    PathPlot { surfaces, range: PlotRange::Objects, ..PathPlot::new(plane, psis.iter().zip(names).map(line).collect()) }
}

/// Returns r(θ) = S e^(θ tan ψ), by s in [0, 1] with ln r = ln S + s L and θ = s L cot ψ, which includes radial rays.
fn spiral(ratio: f64, psi: f64) -> Curve {
    let start = 1.0 / ratio;
    let (rise, run) = psi.to_radians().sin_cos();
    let [grow, turn] = if rise.abs() < 1e-9 {
        [0.0, TAU.copysign(run)]
    } else {
        let end: f64 = if rise > 0.0 { 1.0 } else { INNERMOST };
        let grow = (end / start).ln();
        [grow, grow * run / rise]
    };
    let segments = ((turn.abs() / TAU + grow.abs()) * SEGMENTS).ceil().max(1.0);
    let point = |i: u32| {
        let s = f64::from(i) / segments;
        let (sin, cos) = (s * turn).sin_cos();
        let r = start * (s * grow).exp();
        let x = [r * cos, r * sin, 0.0];
        let v = [r * (grow * cos - turn * sin), r * (grow * sin + turn * cos), 0.0];
        PathPoint { x, v, tau: s }
    };
    Curve::of(&(0..=segments as u32).map(point).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::windings;

    #[test]
    fn the_reflectance_is_right_where_it_is_known() {
        for eta in [1.0001_f64, 1.4, 2.42, 3.0, 1.0 / 1.4] {
            let normal = ((eta - 1.0) / (eta + 1.0)).powi(2);
            assert!((reflectance(0.0, eta) - normal).abs() < 1e-15);
            // At the Brewster angle no parallel light is reflected.
            let brewster = eta.atan().to_degrees();
            let half = 0.5 * ((1.0 - eta * eta) / (1.0 + eta * eta)).powi(2);
            assert!((reflectance(brewster, eta) - half).abs() < 1e-14, "{eta}");
            assert!((reflectance(90.0, eta) - 1.0).abs() < 1e-13);
            // Backwards along the refracted ray the reflectance is equal.
            for degrees in [10.0, 30.0, 44.0] {
                let back = refracted_sine(degrees, eta).unwrap().asin().to_degrees();
                assert!((reflectance(degrees, eta) - reflectance(back, 1.0 / eta)).abs() < 1e-12, "{eta} {degrees}");
            }
        }
        // The rounded values of T: 2.8 % for η = 1.4, 2.9 % for √2, 25 % for 3.
        assert!(
            (reflectance(0.0, 2.0_f64.sqrt()) - 0.029).abs() < 5e-4 && (reflectance(0.0, 3.0) - 0.25).abs() < 1e-12
        );
        let beyond = 0.75_f64.asin().to_degrees() + 0.01;
        assert!((reflectance(beyond, 0.75) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn charts_have_their_corners_and_stay_finite() {
        let [fresnel, snell] = [fresnel_chart(&[1.4, 0.75]), snell_chart(&[1.4, 0.75])];
        assert_eq!((fresnel.series.len(), snell.series.len()), (4, 2));
        let last = snell.series[1].points.last().unwrap();
        assert!((last[1] - 90.0).abs() < 1e-5 && (last[0] - 0.75_f64.asin().to_degrees()).abs() < 1e-12, "{last:?}");
        let beer = beer_chart(&[0.5, 1.0], 4.0);
        assert!((beer.series[0].points.last().unwrap()[1] - 0.0625).abs() < 1e-15);
        let charts = [fresnel, snell, beer, spiral_chart(std::f64::consts::E)];
        assert!(charts.iter().flat_map(|c| &c.series).flat_map(|s| &s.points).flatten().all(|v| v.is_finite()));
    }

    #[test]
    fn spirals_keep_their_angle_and_end_where_the_formula_says() {
        let plane = CutPlane { point: DVec3::ZERO, right: DVec3::X, up: DVec3::Y };
        for psi in [0.5, 30.0, 90.0, 120.0, 179.0] {
            let curve = spiral(2.5, psi);
            assert!((curve.end().unwrap().length() - 1.0).abs() < 1e-12);
            let turns = windings(&curve, DVec3::ZERO, &plane);
            let expected = spiral_angle(2.5, psi) / TAU;
            assert!((turns - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{psi}: {turns} {expected}");
            // The angle to the circles is constant: dr / (r dθ) = tan ψ, from adjacent points.
            let points = curve.flattened();
            for ends in points.windows(2) {
                let (middle, step) = (ends[0].midpoint(ends[1]), ends[1] - ends[0]);
                let angle = step.dot(middle).atan2(middle.cross(step).z).to_degrees();
                assert!((angle - psi).abs() < 0.01, "{psi}: {angle}");
            }
        }
        for (psi, turns) in [(0.0, 1.0), (180.0, -1.0)] {
            let curve = spiral(2.0, psi);
            assert!((windings(&curve, DVec3::ZERO, &plane) - turns).abs() < 1e-12);
            assert!(curve.flattened().iter().all(|p| (p.length() - 0.5).abs() < 1e-5));
        }
        assert!(spiral(2.0, 240.0).end().unwrap().length() < 0.01);
    }
}
