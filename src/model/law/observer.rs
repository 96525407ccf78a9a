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

/// A hole that is the same all round, −A dt² + dr²/A + r² dΩ², as observers at a place know it.
pub(super) struct RoundHole {
    /// From the centre.
    pub offset: DVec3,
    /// What orbits go round.
    pub axis: DVec3,
    /// A there.
    pub clock: f64,
    /// A′ there.
    pub slope: f64,
    /// r of the circular orbits of light, within which matter has none.
    pub photon_sphere: f64,
}

impl RoundHole {
    /// The frames of [`Self::observer`].
    pub fn knows(frame: CameraFrame) -> bool {
        frame != CameraFrame::Coordinate
    }

    pub fn metric(&self) -> DMat4 {
        spherical(self.offset.normalize(), 1.0 / self.clock, 1.0, self.clock)
    }

    /// As [`Law::observer`](super::Law::observer). Without spin who rests has no angular momentum, and is at rest in the slices of equal time.
    pub fn observer(&self, frame: CameraFrame) -> Option<Result<DVec4, [String; 2]>> {
        let metric = self.metric();
        let found = match frame {
            CameraFrame::Coordinate => return None,
            CameraFrame::Static | CameraFrame::Normal | CameraFrame::Zamo => normalised(&metric, DVec4::W),
            CameraFrame::Moving(velocity) => moving(&metric, velocity),
            CameraFrame::Orbiting => return Some(self.orbiting(1.0)),
            CameraFrame::CounterOrbiting => return Some(self.orbiting(-1.0)),
            CameraFrame::Falling => return Some(self.falling()),
        };
        Some(found.ok_or_else(|| ["is where nothing is at rest".to_owned(), "move it".to_owned()]))
    }

    /// Ω² = A′/2r, in the plane across the axis.
    fn orbiting(&self, sense: f64) -> Result<DVec4, [String; 2]> {
        let r = self.offset.length();
        let turning = sense * (0.5 * self.slope / r).sqrt();
        let is_level = self.offset.dot(self.axis).abs() <= 1e-9 * r;
        let way = (turning * self.axis.cross(self.offset)).extend(1.0);
        let found = if is_level && turning.is_finite() { normalised(&self.metric(), way) } else { None };
        found.ok_or_else(|| {
            let help = "those are in the plane through the hole across law.axis";
            ["is on no circular orbit".to_owned(), format!("{help}, beyond r = {:.4}", self.photon_sphere)]
        })
    }

    /// With E = 1 and L = 0.
    fn falling(&self) -> Result<DVec4, [String; 2]> {
        let inwards = (1.0 - self.clock).sqrt();
        let u = (-inwards * self.offset.normalize()).extend(1.0 / self.clock);
        let help = "there charge or Λ has turned it round: use frame = \"moving\" and camera.velocity";
        if inwards.is_finite() {
            Ok(u)
        } else {
            Err(["is where nothing has fallen from rest".to_owned(), help.to_owned()])
        }
    }
}
