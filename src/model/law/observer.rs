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
    Eulerian,
    /// Of one with no angular momentum about the hole's axis.
    Zamo,
    /// Of one on a circular orbit round the hole's equator, the way that it spins.
    ProgradeOrbit,
    /// The other way.
    RetrogradeOrbit,
    /// Of one that has fallen from rest, far away, without angular momentum.
    Infalling,
    /// Of one that moves, to one at rest in the slices of equal time, along this direction of the coordinates and at its length, in
    /// parts of light's speed.
    Boosted(DVec3),
}

impl CameraFrame {
    /// As a scene file has them.
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

/// The four-velocity that is along k; none if that is no way of anything slower than light.
fn normalised(metric: &DMat4, k: DVec4) -> Option<DVec4> {
    let length = -k.dot(*metric * k);
    (length > 0.0).then(|| k / length.sqrt())
}

/// At rest in the slices of equal time.
fn normal(metric: &DMat4) -> Option<DVec4> {
    let inverse = metric.inverse();
    normalised(metric, -inverse.col(3))
}

/// Moving past that one, along `velocity` and as fast as it is long.
fn moving(metric: &DMat4, velocity: DVec3) -> Option<DVec4> {
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

/// Returns the four-velocity of an observer at a place with this metric, where `around` is the way round the law's axis and `orbiting`
/// gives dφ/dt of the circular orbit, with φ (1) or against it (−1). `None` if nothing can move so, or if only the law knows how.
pub(super) fn four_velocity(
    metric: &DMat4,
    frame: CameraFrame,
    around: DVec3,
    orbiting: &dyn Fn(f64) -> Option<f64>,
) -> Option<DVec4> {
    let way = |turning: f64| normalised(metric, (turning * around).extend(1.0));
    match frame {
        CameraFrame::Coordinate | CameraFrame::Infalling => None,
        CameraFrame::Static => way(0.0),
        CameraFrame::Eulerian => normal(metric),
        CameraFrame::Boosted(velocity) => moving(metric, velocity),
        CameraFrame::Zamo => {
            let around = around.extend(0.0);
            let (mixed, own) = (around.dot(metric.w_axis), around.dot(*metric * around));
            way(if own > 0.0 { -mixed / own } else { 0.0 })
        }
        CameraFrame::ProgradeOrbit => orbiting(1.0).and_then(way),
        CameraFrame::RetrogradeOrbit => orbiting(-1.0).and_then(way),
    }
}

/// Returns the four-velocity of an observer in a space whose clocks all go alike: at rest, or moving. `None` for the other frames.
pub(super) fn in_space(metric: &DMat4, frame: CameraFrame) -> Option<Result<DVec4, [String; 2]>> {
    let is_known = matches!(frame, CameraFrame::Static | CameraFrame::Eulerian | CameraFrame::Boosted(_));
    let found = || four_velocity(metric, frame, DVec3::ZERO, &|_| None);
    is_known.then(|| found().ok_or_else(|| ["is nowhere", "move it"].map(str::to_owned)))
}
