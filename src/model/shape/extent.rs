//! The extent of objects, for comparison with the bounding sphere.

use glam::{DAffine3, DMat3, DVec3};

use crate::model::halved::halved;

/// Returns the greatest distance from `center` to a point of the mapped unit circle around y at this y.
///
/// The map turns the circle into an ellipse. The diameters of the circle that become its axes are perpendicular before and after the map:
/// at half the angle of (|X|² − |Z|², 2 X·Z), where X and Z are the images of x and z.
pub(super) fn circle(map: &DAffine3, y: f64, center: DVec3) -> f64 {
    let (x, z) = (map.matrix3.x_axis, map.matrix3.z_axis);
    let (sin, cos) = (0.5 * (2.0 * x.dot(z)).atan2(x.length_squared() - z.length_squared())).sin_cos();
    let axes = DMat3::from_cols(cos * x + sin * z, DVec3::ZERO, cos * z - sin * x);
    let middle = map.transform_point3(y * DVec3::Y);
    ellipsoid(&DAffine3 { matrix3: axes, translation: middle }, center)
}

/// Returns the greatest |A u + d| over unit vectors u, for A a rotation after scales σ along the axes.
///
/// At the maximum the gradient is along u: Aᵀ(A u + d) = λu with λ ≥ σ², so that uᵢ = gᵢ / (λ − σᵢ²) with g = Aᵀd, and |u| = 1 determines
/// λ. If |u| stays below 1 down to λ = max σ², the component along the longest axis fills the rest; this also applies if g is too small to
/// separate λ from σ².
pub(super) fn ellipsoid(map: &DAffine3, center: DVec3) -> f64 {
    let (a, d) = (map.matrix3, map.translation - center);
    let squares = DVec3::from_array(a.to_cols_array_2d().map(|axis| DVec3::from(axis).length_squared()));
    let g = a.transpose() * d;
    let u = |lambda: f64| {
        let part = |i: usize| {
            if g[i] == 0.0 || lambda <= squares[i] { 0.0 } else { g[i] / (lambda - squares[i]) }
        };
        DVec3::new(part(0), part(1), part(2))
    };
    // Twice |g| is a safe bound, because rounding may remove up to half of a very small g.
    let (low, high) = (squares.max_element(), squares.max_element() + 2.0 * g.length());
    let mut top = u(halved(low, high, 100, |lambda| u(lambda).length_squared() <= 1.0)[1]);
    let longest = squares.max_position();
    let rest = (1.0 - top.length_squared()).max(0.0);
    top[longest] = (top[longest].powi(2) + rest).sqrt().copysign(top[longest]);
    (a * top + d).length()
}

/// Rounds up to three digits.
#[must_use]
pub fn round_up(x: f64) -> f64 {
    let digit = 10_f64.powf(x.log10().floor() - 2.0);
    let rounded = (x / digit).ceil() * digit;
    // Printing and parsing again removes the digits that the multiplication adds.
    format!("{rounded:.2e}").parse().unwrap_or(rounded)
}
