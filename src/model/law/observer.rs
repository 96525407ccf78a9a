//! Observers, which define the directions of a camera and their motion.
//!
//! Four-vectors have three spatial components followed by the time component.

use glam::{DMat3, DMat4, DVec3, DVec4};

/// The module for the directions of an observer at the camera's only position.
pub const OBSERVER_PART: &str = "camera/frame_observer";

/// The observer whose unit directions the camera uses, under laws for which observers differ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Observer {
    /// Coordinate directions (W04 §5.4).
    Coordinate,
    /// A static observer.
    Static,
    /// An Eulerian observer, at rest in slices of equal time.
    Eulerian,
    /// An observer with zero angular momentum about the black hole's axis.
    Zamo,
    /// An observer on a prograde circular orbit in the black hole's equatorial plane.
    ProgradeOrbit,
    /// An observer on a retrograde circular orbit.
    RetrogradeOrbit,
    /// An observer in free fall from rest at infinity, without angular momentum.
    Infalling,
    /// An observer who moves relative to the Eulerian observer along this coordinate direction, with its length as the speed in units of
    /// the speed of light.
    Boosted(DVec3),
}

impl Observer {
    /// The names in a scene file.
    pub const WORDS: [(&'static str, Self); 8] = [
        ("coordinate", Self::Coordinate),
        ("static", Self::Static),
        ("eulerian", Self::Eulerian),
        ("zamo", Self::Zamo),
        ("prograde-orbit", Self::ProgradeOrbit),
        ("retrograde-orbit", Self::RetrogradeOrbit),
        ("infalling", Self::Infalling),
        ("boosted", Self::Boosted(DVec3::ZERO)),
    ];
}

/// Returns the four-velocity along k, or `None` if k is not timelike.
fn normalised(metric: &DMat4, k: DVec4) -> Option<DVec4> {
    let length = -k.dot(*metric * k);
    (length > 0.0).then(|| k / length.sqrt())
}

/// Returns the four-velocity of the Eulerian observer.
fn normal(metric: &DMat4) -> Option<DVec4> {
    let inverse = metric.inverse();
    normalised(metric, -inverse.col(3))
}

/// Returns the four-velocity of an observer who moves relative to the Eulerian observer with `velocity`.
fn moving(metric: &DMat4, velocity: DVec3) -> Option<DVec4> {
    let along = velocity.extend(0.0);
    let length = along.dot(*metric * along).sqrt();
    let stretched = if length > 0.0 { velocity.length() / length } else { 0.0 };
    normalised(metric, normal(metric)? + stretched * along)
}

/// Returns κ of v/κ from aκ² + 2bκ = c, as the shader's `light_speed` does.
pub(super) fn light_speed(a: f64, b: f64, c: f64) -> f64 {
    let root = (b * b + a * c).sqrt();
    let (faster, slower) = (c / (b + root), c / (b - root));
    let is_slow = a < 0.0 && (slower - 1.0).abs() < (faster - 1.0).abs();
    let kappa = if is_slow { slower } else { faster };
    if kappa > 0.0 { kappa } else { 0.0 }
}

/// Returns the metric −A dt² with A = `clock`, with squared lengths along the unit vector n and across it scaled by these factors.
pub(super) fn spherical(n: DVec3, along: f64, across: f64, clock: f64) -> DMat4 {
    let radial = DMat3::from_cols(n.x * n, n.y * n, n.z * n);
    let mut metric = DMat4::from_mat3(across * DMat3::IDENTITY + (along - across) * radial);
    metric.w_axis = DVec4::new(0.0, 0.0, 0.0, -clock);
    metric
}

/// Returns the four-velocity of an observer at a position with this metric, or `None` for impossible motion and for frames that only the
/// law can compute. `around` is the azimuthal vector; `orbiting` returns dφ/dt of the circular orbit, with φ (1) or against it (−1).
pub(super) fn four_velocity(
    metric: &DMat4,
    frame: Observer,
    around: DVec3,
    orbiting: &dyn Fn(f64) -> Option<f64>,
) -> Option<DVec4> {
    let way = |turning: f64| normalised(metric, (turning * around).extend(1.0));
    match frame {
        Observer::Coordinate | Observer::Infalling => None,
        Observer::Static => way(0.0),
        Observer::Eulerian => normal(metric),
        Observer::Boosted(velocity) => moving(metric, velocity),
        Observer::Zamo => {
            let around = around.extend(0.0);
            let (mixed, own) = (around.dot(metric.w_axis), around.dot(*metric * around));
            way(if own > 0.0 { -mixed / own } else { 0.0 })
        }
        Observer::ProgradeOrbit => orbiting(1.0).and_then(way),
        Observer::RetrogradeOrbit => orbiting(-1.0).and_then(way),
    }
}

/// Returns the four-velocity of a static or moving observer in a space without time dilation, or `None` for the other frames.
pub(super) fn in_space(metric: &DMat4, frame: Observer) -> Option<Result<DVec4, [String; 2]>> {
    let is_known = matches!(frame, Observer::Static | Observer::Eulerian | Observer::Boosted(_));
    let found = || four_velocity(metric, frame, DVec3::ZERO, &|_| None);
    is_known.then(|| found().ok_or_else(|| ["is where this observer cannot exist", "move it"].map(str::to_owned)))
}
