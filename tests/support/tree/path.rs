//! Paths through media, each as a function of a separate parameter.

use bentray::model::medium::{Constant, Fisheye, Gaussian, Ingoing, InverseR, Linear, Luneburg, Rod};
use bentray::scene::Medium;
use glam::DVec3;

use super::series::Series;

/// A position on a path, and its unit direction there.
pub type Point = (DVec3, DVec3);

/// A path from parameter 0 on.
#[derive(Debug, Clone)]
pub enum Path {
    /// x + s d, s in scene units.
    Line { x: DVec3, d: DVec3 },
    /// along(s) + A cos ωs + B sin ωs, with along(s) = base + s drift.
    Harmonic { base: DVec3, drift: DVec3, a: DVec3, b: DVec3, omega: f64 },
    /// x + s v + s² g/2.
    Parabola { x: DVec3, v: DVec3, g: DVec3 },
    /// r = S e^(s sin ψ) at the angle s cos ψ from `radial` towards `across`.
    Spiral { center: DVec3, start: f64, radial: DVec3, across: DVec3, sin: f64, cos: f64 },
    /// A circle of curvature κ toward `inward`, s in scene units.
    Circle { x: DVec3, d: DVec3, inward: DVec3, curvature: f64 },
    /// A path by Taylor series.
    Series(Series),
}

/// Returns the index at `x`.
pub fn index(medium: &dyn Medium, x: DVec3) -> f64 {
    if let Some(Constant { n }) = medium.downcast() {
        *n
    } else if let Some(Luneburg { center, radius, c }) = medium.downcast() {
        (c - x.distance_squared(*center) / radius.powi(2)).sqrt()
    } else if let Some(Gaussian { center, radius, a, b }) = medium.downcast() {
        a * (-b * x.distance_squared(*center) / radius.powi(2)).exp()
    } else if let Some(InverseR { center, k, .. }) = medium.downcast() {
        k / x.distance(*center)
    } else if let Some(Fisheye { center, n0, a }) = medium.downcast() {
        n0 / (1.0 + x.distance_squared(*center) / a.powi(2))
    } else if let Some(Rod { center, axis, n0, g }) = medium.downcast() {
        n0 * (1.0 - g.powi(2) * (x - center).reject_from_normalized(*axis).length_squared()).sqrt()
    } else if let Some(Linear { origin, n0, gradient }) = medium.downcast() {
        (n0.powi(2) + gradient.dot(x - origin)).sqrt()
    } else {
        panic!("the tracer does not support {medium:?}")
    }
}

impl Path {
    /// Returns the path from `x` along the unit vector `d`.
    pub fn new(medium: &dyn Medium, x: DVec3, d: DVec3) -> Self {
        let v = index(medium, x) * d;
        if let Some(Luneburg { center, radius, .. }) = medium.downcast() {
            let omega = 1.0 / radius;
            Self::Harmonic { base: *center, drift: DVec3::ZERO, a: x - center, b: v / omega, omega }
        } else if let Some(Rod { center, axis, n0, g }) = medium.downcast() {
            let [aside, swing] = [x - center, v].map(|vector| vector.reject_from_normalized(*axis));
            let omega = n0 * g;
            Self::Harmonic { base: x - aside, drift: v - swing, a: aside, b: swing / omega, omega }
        } else if let Some(Linear { gradient, .. }) = medium.downcast() {
            Self::Parabola { x, v, g: *gradient / 2.0 }
        } else if let Some(Gaussian { center, radius, b, .. }) = medium.downcast() {
            Self::Series(Series::new(*center, x, v, 2.0 * b / radius.powi(2)))
        } else if let Some(InverseR { center, ingoing, .. }) = medium.downcast() {
            let (start, radial) = ((x - center).length(), (x - center).normalize());
            let sin = d.dot(radial);
            let tangent = d - sin * radial;
            let (cos, across) = (tangent.length(), tangent.normalize_or_zero());
            let sin = if *ingoing == Ingoing::Continued { sin.abs() } else { sin };
            Self::Spiral { center: *center, start, radial, across, sin, cos }
        } else if let Some(Fisheye { center, a, .. }) = medium.downcast() {
            // The curvature is the component of ∇ ln n across the path.
            let bend = -2.0 * (x - center) / (a.powi(2) + x.distance_squared(*center));
            let bend = bend.reject_from_normalized(d);
            Self::Circle { x, d, inward: bend.normalize_or_zero(), curvature: bend.length() }
        } else {
            Self::Line { x, d }
        }
    }

    /// Returns the point at parameter `s` ≥ 0.
    pub fn at(&mut self, s: f64) -> Point {
        match self {
            Self::Line { x, d } => (*x + s * *d, *d),
            Self::Harmonic { base, drift, a, b, omega } => {
                let (sin, cos) = (*omega * s).sin_cos();
                let x = *base + s * *drift + *a * cos + *b * sin;
                (x, (*drift + *omega * (*b * cos - *a * sin)).normalize())
            }
            Self::Parabola { x, v, g } => (*x + s * (*v + 0.5 * s * *g), (*v + s * *g).normalize()),
            Self::Spiral { center, start, radial, across, sin, cos } => {
                let (s_angle, c_angle) = (s * *cos).sin_cos();
                let outward = *radial * c_angle + *across * s_angle;
                let around = *across * c_angle - *radial * s_angle;
                (*center + *start * (s * *sin).exp() * outward, *sin * outward + *cos * around)
            }
            Self::Circle { x, d, inward, curvature } => {
                // sin(κs)/κ and (1 − cos κs)/κ; a straight line if κ is 0.
                let angle = *curvature * s;
                let half = 0.5 * angle;
                let ahead = if angle == 0.0 { s } else { angle.sin() / *curvature };
                let aside = if angle == 0.0 { 0.0 } else { 2.0 * half.sin().powi(2) / *curvature };
                (*x + ahead * *d + aside * *inward, angle.cos() * *d + angle.sin() * *inward)
            }
            Self::Series(series) => series.at(s),
        }
    }

    /// Returns a change of the parameter over which the path hardly turns and is at most `reach` long.
    pub fn stride(&self, reach: f64) -> f64 {
        match self {
            Self::Line { .. } => reach,
            Self::Harmonic { drift, b, omega, .. } => {
                let speed = (*drift + *omega * *b).length();
                (0.05 / *omega).min(reach / speed)
            }
            Self::Parabola { v, g, .. } => (0.01 * v.length() / g.length()).min(reach / v.length()),
            Self::Spiral { .. } => 0.05,
            Self::Circle { curvature, .. } => (0.05 / *curvature).min(reach),
            Self::Series(series) => series.stride().min(reach / series.speed()),
        }
    }

    /// Returns `true` if `x` is so close to a center that the path can end.
    pub fn has_ended(&self, x: DVec3) -> bool {
        matches!(self, Self::Spiral { center, start, .. } if x.distance(*center) < 1e-7 * *start)
    }
}
