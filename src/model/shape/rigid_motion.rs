//! Moving objects, which rotate around an axis at a constant rate or move in a straight line.
//!
//! *Theory.* Light takes time to arrive: a ray traced back for τ meets an object at its position at t − τ. The ray is transformed into the
//! object's rest frame, which undoes the motion, and a moving object is then intersected like a static one.
//!
//! *Practice.* The shape is specified on a slice of constant t in the scene's coordinates and keeps this form, so it must be given
//! Lorentz-contracted.

use glam::{DMat3, DVec3};

use crate::document::reader::TableReader;
use crate::document::values::{number, vector};
use crate::document::{Node, Value};
use crate::model::{Law, Observer, Row, row};

/// The motion of an object, which has its placement at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidMotion {
    /// A point of the axis of rotation.
    pub center: DVec3,
    /// The unit vector along the axis of rotation.
    pub axis: DVec3,
    /// The angular velocity dφ/dt around the axis.
    pub turning: f64,
    /// The additional linear velocity.
    pub velocity: DVec3,
}

impl RigidMotion {
    /// Creates a rotation around an axis.
    #[must_use]
    pub fn round(center: DVec3, axis: DVec3, turning: f64) -> Self {
        Self { center, axis, turning, velocity: DVec3::ZERO }
    }

    /// Creates a motion in a straight line.
    #[must_use]
    pub fn straight(velocity: DVec3) -> Self {
        Self { center: DVec3::ZERO, axis: DVec3::Z, turning: 0.0, velocity }
    }

    /// Returns the position at t of the point that is at `x` at t = 0.
    #[must_use]
    pub fn place(&self, x: DVec3, t: f64) -> DVec3 {
        let turn = DMat3::from_axis_angle(self.axis, self.turning * t);
        self.center + turn * (x - self.center) + t * self.velocity
    }

    /// Returns the velocity at t = 0 of the point at `x`.
    #[must_use]
    pub fn velocity_at(&self, x: DVec3) -> DVec3 {
        self.velocity + self.turning * self.axis.cross(x - self.center)
    }

    /// Returns a bounding box of all positions of a moving ball, or `None` if they are unbounded.
    #[must_use]
    pub fn swept(&self, (middle, radius): (DVec3, f64)) -> Option<(DVec3, DVec3)> {
        if self.velocity != DVec3::ZERO {
            return None;
        }
        let d = middle - self.center;
        let along = d.dot(self.axis) * self.axis;
        let across = (DVec3::ONE - self.axis * self.axis).max(DVec3::ZERO).map(f64::sqrt);
        let half = (d - along).length() * across + radius;
        Some((self.center + along - half, self.center + along + half))
    }

    /// Returns the greatest distance of a moving ball from a point, or `None` if it is unbounded.
    #[must_use]
    pub fn farthest(&self, (middle, radius): (DVec3, f64), from: DVec3) -> Option<f64> {
        if self.velocity != DVec3::ZERO {
            return None;
        }
        let height = |x: DVec3| (x - self.center).dot(self.axis);
        let arm = |x: DVec3| (x - self.center - height(x) * self.axis).length();
        Some((arm(middle) + arm(from)).hypot(height(middle) - height(from)) + radius)
    }

    /// Returns the shader values for an image at `time`, without the index of the moving object.
    #[must_use]
    pub fn values(&self, (middle, radius): (DVec3, f64), time: f64) -> Row {
        let angle = (self.turning * time).rem_euclid(std::f64::consts::TAU);
        row! {
            center: Vec3(self.center),
            turning: Float(self.turning),
            axis: Vec3(self.axis),
            angle: Float(angle),
            velocity: Vec3(self.velocity),
            offset: Vec3(time * self.velocity),
            reach: Float(middle.distance(self.center) + radius),
            middle: Vec3(middle),
            radius: Float(radius),
        }
    }
}

/// Reads the motion of an object at this placement; reports errors to the table.
pub(super) fn read(table: &TableReader, law: Option<&dyn Law>, middle: Option<DVec3>) -> Option<RigidMotion> {
    let (key, node) = table.one_of(&["orbit", "velocity"])?;
    let (law, middle) = (law?, middle?);
    let travel = if key == "orbit" {
        orbit(table, node, law, middle)?
    } else {
        RigidMotion::straight(table.reader.accept(vector(node))?)
    };
    let k = travel.velocity_at(middle).extend(1.0);
    if law.metric(middle, 0.0).is_some_and(|metric| k.dot(metric * k) >= 0.0) {
        let help = "reduce its speed, or move it elsewhere";
        table.fault(&[key], "the object would move at the speed of light or faster", help);
    }
    Some(travel)
}

/// Reads a circular orbit of the law, prograde or retrograde, or with a specified angular velocity.
fn orbit(table: &TableReader, node: &Node, law: &dyn Law, middle: DVec3) -> Option<RigidMotion> {
    let Some([center, axis]) = law.equator() else {
        let help = "use `velocity`, or law.kind = \"kerr-newman\"";
        table.fault(&["orbit"], "this law has no center that an object could orbit", help);
        return None;
    };
    let frame = match &node.value {
        Value::Text(word) if word == "prograde" => Observer::ProgradeOrbit,
        Value::Text(word) if word == "retrograde" => Observer::RetrogradeOrbit,
        Value::Integer(_) | Value::Float(_) => {
            return Some(RigidMotion::round(center, axis, table.reader.accept(number(node))?));
        }
        _ => {
            table.reader.fault(node.expected("\"prograde\", \"retrograde\" or an angular velocity"));
            return None;
        }
    };
    match law.observer(frame, middle)? {
        Ok(u) => {
            let arm = middle - center;
            let around = axis.cross(arm);
            Some(RigidMotion::round(center, axis, u.truncate().dot(around) / (u.w * around.length_squared())))
        }
        Err([problem, help]) => {
            table.fault(&["orbit"], format!("the object {problem}"), help);
            None
        }
    }
}
