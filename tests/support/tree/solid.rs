//! Shapes in their own spaces, and objects in their places.

use bentray::scene::{Object, Shape};
use glam::{DAffine3, DVec2, DVec3};

/// The shapes that the tracer knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Solid {
    /// |p| ≤ 1.
    Ball,
    /// |x|, |y|, |z| ≤ 1.
    Cube,
    /// |x|, |z| ≤ 1 in y = 0: it has sides, but no inside.
    Square,
}

/// A shape in its place.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    solid: Solid,
    /// From the scene's space to the shape's own.
    inward: DAffine3,
}

impl Body {
    /// The object's shape; fails on shapes that the tracer does not know.
    pub fn new(object: &Object) -> Self {
        let solid = if matches!(object.shape, Shape::Sphere) {
            Solid::Ball
        } else if matches!(object.shape, Shape::Box) {
            Solid::Cube
        } else if matches!(object.shape, Shape::Plane) {
            Solid::Square
        } else {
            panic!("the tracer knows no such shape")
        };
        Self { solid, inward: object.transform.0.inverse() }
    }

    /// A point in the shape's own space.
    pub fn own(&self, x: DVec3) -> DVec3 {
        self.inward.transform_point3(x)
    }

    /// Below 0 inside, 0 on the surface; no steeper than 1 in the shape's own space, where `p` is. Of a square, the side.
    pub fn level(&self, p: DVec3) -> f64 {
        match self.solid {
            Solid::Ball => p.length() - 1.0,
            Solid::Cube => p.abs().max_element() - 1.0,
            Solid::Square => p.y,
        }
    }

    /// Is a point at level 0 a point of the surface?
    pub fn reaches(&self, p: DVec3) -> bool {
        self.solid != Solid::Square || p.x.abs().max(p.z.abs()) <= 1.0
    }

    /// Has it no inside?
    pub fn is_open(&self) -> bool {
        self.solid == Solid::Square
    }

    /// Where the line x + t d enters and leaves; a square is left where it is entered.
    pub fn span(&self, x: DVec3, d: DVec3) -> Option<[f64; 2]> {
        let (p, d) = (self.own(x), self.inward.transform_vector3(d));
        match self.solid {
            Solid::Ball => {
                // From the nearest point: its distance loses no digits far away.
                let middle = -p.dot(d) / d.length_squared();
                let inside = 1.0 - (p + middle * d).length_squared();
                let half = (inside / d.length_squared()).sqrt();
                (inside > 0.0).then_some([middle - half, middle + half])
            }
            Solid::Cube => {
                let mut span = [f64::NEG_INFINITY, f64::INFINITY];
                for axis in 0..3 {
                    if d[axis] == 0.0 {
                        if p[axis].abs() > 1.0 {
                            return None;
                        }
                    } else {
                        let walls = [(-1.0 - p[axis]) / d[axis], (1.0 - p[axis]) / d[axis]];
                        span = [span[0].max(walls[0].min(walls[1])), span[1].min(walls[0].max(walls[1]))];
                    }
                }
                (span[0] < span[1]).then_some(span)
            }
            Solid::Square => {
                let t = -p.y / d.y;
                (d.y != 0.0 && self.reaches(p + t * d)).then_some([t, t])
            }
        }
    }

    /// The unit normal at a point of the surface, outward; of a square, +y.
    pub fn normal(&self, x: DVec3) -> DVec3 {
        let p = self.own(x);
        let gradient = match self.solid {
            Solid::Ball => p,
            Solid::Cube => {
                let axis = p.abs().max_position();
                DVec3::AXES[axis] * p[axis].signum()
            }
            Solid::Square => DVec3::Y,
        };
        (self.inward.matrix3.transpose() * gradient).normalize()
    }

    /// (u, v) at a point of the surface.
    pub fn uv(&self, x: DVec3) -> DVec2 {
        use std::f64::consts::PI;
        let p = self.own(x);
        match self.solid {
            Solid::Ball => DVec2::new(0.5 + p.x.atan2(p.z) / (2.0 * PI), 0.5 + p.y.atan2(p.x.hypot(p.z)) / PI),
            // Upright and not mirrored as seen from outside.
            Solid::Cube => {
                let axis = p.abs().max_position();
                let side = p[axis].signum();
                let q = [DVec2::new(-side * p.z, p.y), DVec2::new(p.x, -side * p.z), DVec2::new(side * p.x, p.y)];
                0.5 + 0.5 * q[axis]
            }
            Solid::Square => DVec2::new(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.z),
        }
    }
}
