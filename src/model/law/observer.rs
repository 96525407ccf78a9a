//! Observers: whose directions a camera's are, and how they move.
//!
//! Four-vectors have the place's three components first, and then the time's.

use glam::{DMat3, DMat4, DVec3, DVec4};

/// The part that has the directions of an observer at the camera's one place.
pub const OBSERVER_PART: &str = "camera/frame_observer";

/// Whose unit directions the camera's are, under laws for which that differs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CameraFrame {
    /// Directions are coordinate directions (W04 §5.4).
    Coordinate,
    /// Those that an observer at rest measures.
    Static,
    /// Of one at rest in the slices of equal time.
    Normal,
    /// Of one with no angular momentum about the hole's axis.
    Zamo,
    /// Of one on a circular orbit round the hole's equator, the way that it spins.
    Orbiting,
    /// The other way.
    CounterOrbiting,
    /// Of one that has fallen from rest, far away, without angular momentum.
    Falling,
    /// Of one that moves, to one at rest in the slices of equal time, along this direction of the coordinates and at its length, in
    /// parts of light's speed.
    Moving(DVec3),
}

impl CameraFrame {
    /// As a scene file has them.
    pub const WORDS: [(&'static str, Self); 8] = [
        ("coordinate", Self::Coordinate),
        ("static", Self::Static),
        ("normal", Self::Normal),
        ("zamo", Self::Zamo),
        ("orbiting", Self::Orbiting),
        ("counter-orbiting", Self::CounterOrbiting),
        ("falling", Self::Falling),
        ("moving", Self::Moving(DVec3::ZERO)),
    ];
}

/// The four-velocity that is along k; none if that is no way of anything slower than light.
pub(super) fn normalised(metric: &DMat4, k: DVec4) -> Option<DVec4> {
    let length = -k.dot(*metric * k);
    (length > 0.0).then(|| k / length.sqrt())
}

/// At rest in the slices of equal time.
pub(super) fn normal(metric: &DMat4) -> Option<DVec4> {
    let inverse = metric.inverse();
    normalised(metric, -inverse.col(3))
}

/// Moving past that one, along `velocity` and as fast as it is long.
pub(super) fn moving(metric: &DMat4, velocity: DVec3) -> Option<DVec4> {
    let along = velocity.extend(0.0);
    let length = along.dot(*metric * along).sqrt();
    let stretched = if length > 0.0 { velocity.length() / length } else { 0.0 };
    normalised(metric, normal(metric)? + stretched * along)
}

/// κ of v/κ from aκ² + 2bκ = c: as the shader's `light_speed`.
pub(super) fn light_speed(a: f64, b: f64, c: f64) -> f64 {
    let root = (b * b + a * c).sqrt();
    let (faster, slower) = (c / (b + root), c / (b - root));
    let is_slow = a < 0.0 && (slower - 1.0).abs() < (faster - 1.0).abs();
    let kappa = if is_slow { slower } else { faster };
    if kappa > 0.0 { kappa } else { 0.0 }
}

/// −A dt² with A = `clock`, and in space lengths squared along the unit vector n and across it, by these factors.
pub(super) fn spherical(n: DVec3, along: f64, across: f64, clock: f64) -> DMat4 {
    let radial = DMat3::from_cols(n.x * n, n.y * n, n.z * n);
    let mut metric = DMat4::from_mat3(across * DMat3::IDENTITY + (along - across) * radial);
    metric.w_axis = DVec4::new(0.0, 0.0, 0.0, -clock);
    metric
}
