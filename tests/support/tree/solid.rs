//! Shapes in object space, and their placement in the scene.

use bentray::model::shape::{Cuboid, Cylinder, Disk, Plane, Sphere};
use bentray::scene::Object;
use glam::{DAffine3, DVec2, DVec3};

/// The shapes that the tracer supports.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Primitive {
    /// |p| ≤ 1.
    Ball,
    /// |x|, |y|, |z| ≤ 1.
    Cube,
    /// x² + z² ≤ 1, |y| ≤ 1.
    Rod,
    /// |x|, |z| ≤ 1 in y = 0: it has two sides, but no inside.
    Square,
    /// hole² ≤ x² + z² ≤ 1 in y = 0, also without an inside.
    Ring { hole: f64 },
}

/// A shape with its placement.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    solid: Primitive,
    /// The map from the scene to object space.
    inward: DAffine3,
}

impl Body {
    /// Returns the shape of the object; panics for unsupported shapes.
    pub fn new(object: &Object) -> Self {
        let shape = &object.shape;
        let known = [
            shape.downcast().map(|Sphere| Primitive::Ball),
            shape.downcast().map(|Cuboid| Primitive::Cube),
            shape.downcast().map(|Cylinder| Primitive::Rod),
            shape.downcast().map(|Plane| Primitive::Square),
            shape.downcast().map(|Disk { hole }| Primitive::Ring { hole: *hole }),
        ];
        let solid = known.into_iter().flatten().next().expect("the tracer does not support this shape");
        Self { solid, inward: object.transform.0.inverse() }
    }

    /// Returns a point in object space.
    pub fn own(&self, x: DVec3) -> DVec3 {
        self.inward.transform_point3(x)
    }

    /// Returns the level of a point in object space: below 0 inside, 0 on the
    /// surface, with a slope of at most 1. For an open shape its sign is the side.
    pub fn level(&self, p: DVec3) -> f64 {
        match self.solid {
            Primitive::Ball => p.length() - 1.0,
            Primitive::Cube => p.abs().max_element() - 1.0,
            Primitive::Rod => p.x.hypot(p.z).max(p.y.abs()) - 1.0,
            Primitive::Square | Primitive::Ring { .. } => p.y,
        }
    }

    /// Returns `true` if a point at level 0 is a point of the surface.
    pub fn reaches(&self, p: DVec3) -> bool {
        match self.solid {
            Primitive::Square => p.x.abs().max(p.z.abs()) <= 1.0,
            Primitive::Ring { hole } => (hole..=1.0).contains(&p.x.hypot(p.z)),
            Primitive::Ball | Primitive::Cube | Primitive::Rod => true,
        }
    }

    /// Returns `true` if the shape has no inside.
    pub fn is_open(&self) -> bool {
        matches!(self.solid, Primitive::Square | Primitive::Ring { .. })
    }

    /// Returns the parameters at which the line x + t d enters and leaves; for an open shape they are equal.
    pub fn span(&self, x: DVec3, d: DVec3) -> Option<[f64; 2]> {
        let (p, d) = (self.own(x), self.inward.transform_vector3(d));
        match self.solid {
            Primitive::Ball => round(p, d),
            Primitive::Cube => {
                let walls = [slab(p.x, d.x)?, slab(p.y, d.y)?, slab(p.z, d.z)?];
                both(both(walls[0], walls[1])?, walls[2])
            }
            Primitive::Rod => {
                let across = DVec3::new(1.0, 0.0, 1.0);
                let walls = slab(p.y, d.y)?;
                if d.x == 0.0 && d.z == 0.0 {
                    return (p.x.hypot(p.z) < 1.0).then_some(walls);
                }
                both(round(p * across, d * across)?, walls)
            }
            Primitive::Square | Primitive::Ring { .. } => {
                let t = -p.y / d.y;
                (d.y != 0.0 && self.reaches(p + t * d)).then_some([t, t])
            }
        }
    }

    /// Returns the outward unit normal at a point of the surface; +y for an open shape.
    pub fn normal(&self, x: DVec3) -> DVec3 {
        let p = self.own(x);
        let gradient = match self.solid {
            Primitive::Ball => p,
            Primitive::Cube => {
                let axis = p.abs().max_position();
                DVec3::AXES[axis] * p[axis].signum()
            }
            Primitive::Rod if p.y.abs() > p.x.hypot(p.z) => DVec3::Y * p.y.signum(),
            Primitive::Rod => DVec3::new(p.x, 0.0, p.z),
            Primitive::Square | Primitive::Ring { .. } => DVec3::Y,
        };
        (self.inward.matrix3.transpose() * gradient).normalize()
    }

    /// Returns (u, v) at a point of the surface.
    pub fn uv(&self, x: DVec3) -> DVec2 {
        use std::f64::consts::PI;
        let p = self.own(x);
        let turn = 0.5 + p.x.atan2(p.z) / (2.0 * PI);
        let rho = p.x.hypot(p.z);
        match self.solid {
            Primitive::Ball => DVec2::new(turn, 0.5 + p.y.atan2(rho) / PI),
            // Upright and not mirrored as seen from outside.
            Primitive::Cube => {
                let axis = p.abs().max_position();
                let side = p[axis].signum();
                let q = [DVec2::new(-side * p.z, p.y), DVec2::new(p.x, -side * p.z), DVec2::new(side * p.x, p.y)];
                0.5 + 0.5 * q[axis]
            }
            // Over the lower face outward, up the mantle, over the upper face inward.
            Primitive::Rod if p.y.abs() <= rho => DVec2::new(turn, 0.5 + 0.5 * p.y),
            Primitive::Rod => DVec2::new(turn, if p.y > 0.0 { 1.0 - rho } else { rho }),
            Primitive::Square => DVec2::new(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.z),
            Primitive::Ring { hole } => DVec2::new(turn, (1.0 - rho) / (1.0 - hole)),
        }
    }
}

/// Returns the interval of p + t d in the unit ball.
fn round(p: DVec3, d: DVec3) -> Option<[f64; 2]> {
    // From the nearest point, because its distance loses no digits far away.
    let middle = -p.dot(d) / d.length_squared();
    let inside = 1.0 - (p + middle * d).length_squared();
    let half = (inside / d.length_squared()).sqrt();
    (inside > 0.0).then_some([middle - half, middle + half])
}

/// Returns the interval in which a coordinate is within ±1.
fn slab(p: f64, d: f64) -> Option<[f64; 2]> {
    if d == 0.0 {
        return (p.abs() <= 1.0).then_some([f64::NEG_INFINITY, f64::INFINITY]);
    }
    let walls = [(-1.0 - p) / d, (1.0 - p) / d];
    Some([walls[0].min(walls[1]), walls[0].max(walls[1])])
}

/// Returns the intersection of two intervals.
fn both(a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
    let span = [a[0].max(b[0]), a[1].min(b[1])];
    (span[0] < span[1]).then_some(span)
}
